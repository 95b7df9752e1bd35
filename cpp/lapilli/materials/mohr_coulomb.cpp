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

MohrCoulombLaw::MohrCoulombLaw(const MohrCoulomb& material) {
  check(material);
  const double degree = std::numbers::pi / 180.0;
  const double sine = std::sin(material.friction_angle * degree);
  const double cosine = std::cos(material.friction_angle * degree);
  const double dilatancy = std::sin(material.dilatancy_angle * degree);
  const double nu = material.elastic.poissons_ratio;
  above = 1.0 + sine;
  below = cosine * cosine / above;  // 1 - sin phi, without cancellation
  strength = 2.0 * material.cohesion * cosine;

  // Elastic stress of the flow direction (1 + sin psi, 0, sin psi - 1), over 2 mu.
  const double volumetric = 2.0 * dilatancy * nu / (1.0 - 2.0 * nu);
  flow1 = volumetric + 1.0 + dilatancy;
  flow2 = volumetric;
  flow3 = volumetric + dilatancy - 1.0;
  flow_left = 0.5 * (flow1 + flow2);
  flow_right = 0.5 * (flow2 + flow3);
  plane = 1.0 / (above * flow1 - below * flow3);
  left = 1.0 / (above * flow_left - below * flow3);
  right = 1.0 / (above * flow1 - below * flow_right);

  // Without friction the cone has no apex: the cut-off is then out of reach, not infinite.
  const double unreachable = 1e100;
  const double apex = sine > 0.0 ? strength / (2.0 * sine) : unreachable;
  tension = std::min({material.tension_cutoff, apex, unreachable});
  tension3 = std::min((above * tension - strength) / below, tension);
  poissons_ratio = nu;
  lateral = nu / (1.0 - nu);
}

SymmetricTensor MohrCoulombLaw::stress_and_slope(const SymmetricTensor& trial, double* /*state*/,
                                                 StressSlope& slope) const {
  return differentiate_principal(
      [this](const auto& t1, const auto& t2, const auto& t3) {
        return return_sorted(*this, t1, t2, t3);
      },
      trial, slope);
}

}  // namespace lapilli
