#include "lapilli/materials/mohr_coulomb.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lapilli/core/require.hpp"
#include "lapilli/materials/slope_of_return.hpp"

namespace lapilli {

void check(const MohrCoulomb& material) {
  check(material.elastic);
  require(material.friction_angle >= 0.0 && material.friction_angle <= 89.999,
          "Mohr-Coulomb: friction_angle must lie in [0, 89.999] degrees, got ",
          material.friction_angle);
  require(material.dilatancy_angle >= 0.0 && material.dilatancy_angle <= material.friction_angle,
          "Mohr-Coulomb: dilatancy_angle must lie between 0 and the friction angle of ",
          material.friction_angle, " degrees, got ", material.dilatancy_angle);
  require(std::isfinite(material.cohesion) && material.cohesion >= 0.0,
          "Mohr-Coulomb: cohesion must not be negative (Pa), got ", material.cohesion);
  require(material.tension_cutoff >= 0.0,
          "Mohr-Coulomb: tension_cutoff must not be negative (Pa), got ", material.tension_cutoff);
}

namespace {

MohrCoulombNumbers<double> numbers_of(const MohrCoulomb& material) {
  check(material);
  const double degree = std::numbers::pi / 180.0;
  const double sine = std::sin(material.friction_angle * degree);
  const double cosine = std::cos(material.friction_angle * degree);
  return {sine,
          cosine * cosine / (1.0 + sine),
          2.0 * material.cohesion * cosine,
          std::sin(material.dilatancy_angle * degree),
          material.tension_cutoff,
          material.elastic.poissons_ratio};
}

}  // namespace

MohrCoulombLaw::MohrCoulombLaw(const MohrCoulomb& material)
    : MohrCoulombNumbers<double>(numbers_of(material)) {}

SymmetricTensor MohrCoulombLaw::stress_and_slope(const SymmetricTensor& trial, double* /*state*/,
                                                 StressSlope& slope) const {
  return differentiate_principal(
      [this](const auto& t1, const auto& t2, const auto& t3) {
        return return_sorted<double>(*this, t1, t2, t3);
      },
      trial, slope);
}

}  // namespace lapilli
