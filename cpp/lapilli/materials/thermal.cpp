#include "lapilli/materials/thermal.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

Vec3 principal_conductivities(const Thermal& material) {
  return material.conductivity.matrix().selfadjointView<Eigen::Lower>().eigenvalues();
}

}  // namespace

void check(const Thermal& material) {
  require(std::isfinite(material.density) && material.density > 0.0,
          "thermal material: density must be positive (kg/m^3), got ", material.density);
  require(std::isfinite(material.specific_heat) && material.specific_heat > 0.0,
          "thermal material: specific_heat must be positive (J/(kg K)), got ",
          material.specific_heat);
  double largest = 0.0;
  for (double component : material.conductivity.components) {
    require(std::isfinite(component),
            "thermal material: conductivity must be finite (W/(m K)), got ", component);
    largest = std::max(largest, std::abs(component));
  }
  const double least = principal_conductivities(material).minCoeff();
  require(
      least >= -1e-12 * largest,
      "thermal material: conductivity must not be negative in any direction (W/(m K)), its least "
      "principal value is ",
      least);
}

double largest_conductivity(const Thermal& material) {
  return principal_conductivities(material).maxCoeff();
}

}  // namespace lapilli
