#include "lapilli/materials/elastic.hpp"

#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

void check(const LinearElastic& material) {
  require(std::isfinite(material.density) && material.density > 0.0,
          "elastic material: density must be positive (kg/m^3), got ", material.density);
  require(std::isfinite(material.youngs_modulus) && material.youngs_modulus > 0.0,
          "elastic material: youngs_modulus must be positive (Pa), got ", material.youngs_modulus);
  require(material.poissons_ratio > -1.0 && material.poissons_ratio < 0.5,
          "elastic material: poissons_ratio must lie in (-1, 0.5), got ", material.poissons_ratio);
}

}  // namespace lapilli
