#include "lapilli/materials/thermal.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

Vec3 principal_conductivities(const Thermal& material) {
  return material.conductivity.largest().matrix().selfadjointView<Eigen::Lower>().eigenvalues();
}

void check_melting(const Thermal& material) {
  require(std::isfinite(material.latent_heat) && material.latent_heat >= 0.0,
          "thermal material: latent_heat must not be negative (J/kg), got ", material.latent_heat);
  const bool says_where = material.solidus || material.liquidus;
  require(!material.melts() || says_where,
          "thermal material: latent_heat needs solidus (and liquidus), the temperatures between "
          "which the material melts");
  require(material.melts() || !says_where,
          "thermal material: solidus and liquidus need a latent_heat above 0");
  require(material.melting_begins() <= material.melting_ends(), "thermal material: solidus ",
          material.melting_begins(), " K lies above liquidus ", material.melting_ends(), " K");
}

}  // namespace

void check(const Thermal& material) {
  require(std::isfinite(material.density) && material.density > 0.0,
          "thermal material: density must be positive (kg/m^3), got ", material.density);
  const auto require_table = [](const char* name, const auto& property) {
    if (const TemperatureTable* table = property.table()) {
      const std::string mistake = mistake_in(*table);
      require(mistake.empty(), "thermal material: ", name, " ", mistake);
    }
  };
  require_table("specific_heat", material.specific_heat);
  require_table("conductivity", material.conductivity);
  const double least_heat = material.specific_heat.least();
  require(std::isfinite(least_heat) && least_heat > 0.0,
          "thermal material: specific_heat must be positive (J/(kg K)), got ", least_heat);
  check_melting(material);
  if (const TemperatureTable* table = material.conductivity.table()) {
    require(table->least() > 0.0,
            "thermal material: conductivity must be positive at every temperature (W/(m K)), got ",
            table->least());
    return;
  }
  double largest = 0.0;
  for (double component : material.conductivity.constant().components) {
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

double depth_of_heat(const Thermal& material, double time) {
  return std::sqrt(largest_conductivity(material) / material.capacity() * time);
}

}  // namespace lapilli
