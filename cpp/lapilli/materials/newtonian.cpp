#include "lapilli/materials/newtonian.hpp"

#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

void check(const Newtonian& material) {
  require(std::isfinite(material.density) && material.density > 0.0,
          "newtonian material: density must be positive (kg/m^3), got ", material.density);
  require(std::isfinite(material.viscosity) && material.viscosity >= 0.0,
          "newtonian material: viscosity must not be negative (Pa s), got ", material.viscosity);
  require(
      std::isfinite(material.thermal_expansion) && std::isfinite(material.reference_temperature),
      "newtonian material: expansion and reference_temperature must be finite, got ",
      material.thermal_expansion, " and ", material.reference_temperature);
}

}  // namespace lapilli
