#include "lapilli/materials/stiffness.hpp"

namespace lapilli {

SymmetricTensor stress_of(const LinearElastic& material, const SymmetricTensor& strain) {
  SymmetricTensor stress(material.lambda() * strain.trace());
  const double twice_shear = 2.0 * material.shear_modulus();
  for (int k = 0; k < 6; ++k) {
    stress[k] += twice_shear * strain[k];
  }
  return stress;
}

Stiffness stiffness_of(const LinearElastic& material) {
  Stiffness matrix = Stiffness::Zero();
  matrix.topLeftCorner<3, 3>().setConstant(material.lambda());
  matrix.diagonal().head<3>().array() += 2.0 * material.shear_modulus();
  matrix.diagonal().tail<3>().setConstant(material.shear_modulus());
  return matrix;
}

}  // namespace lapilli
