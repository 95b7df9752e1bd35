#include "lapilli/materials/linear_elastic.hpp"

#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

void check(const LinearElastic& material) {
  require(material.youngs_modulus > 0.0 && std::isfinite(material.youngs_modulus),
          "youngs_modulus must be positive and finite, got ", material.youngs_modulus, " Pa");
  require(material.poissons_ratio > -1.0 && material.poissons_ratio < 0.5,
          "poissons_ratio must lie between -1 and 0.5, both excluded, got ", material.poissons_ratio);
}

SymmetricTensor stress_of(const LinearElastic& material, const SymmetricTensor& strain) {
  const double volumetric = material.lame() * strain.trace();
  const double twice_shear = 2.0 * material.shear_modulus();
  SymmetricTensor stress(volumetric);
  for (int k = 0; k < 6; ++k) {
    stress[k] += twice_shear * strain[k];
  }
  return stress;
}

Stiffness stiffness_of(const LinearElastic& material) {
  Stiffness matrix = Stiffness::Zero();
  matrix.topLeftCorner<3, 3>().setConstant(material.lame());
  matrix.diagonal().head<3>().array() += 2.0 * material.shear_modulus();
  matrix.diagonal().tail<3>().setConstant(material.shear_modulus());
  return matrix;
}

}  // namespace lapilli
