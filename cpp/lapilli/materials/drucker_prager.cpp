#include "lapilli/materials/drucker_prager.hpp"

#include <cmath>
#include <numbers>

#include "lapilli/core/require.hpp"
#include "lapilli/materials/slope_of_return.hpp"

namespace lapilli {
namespace {

/// The slope of sqrt(J2) over -I1 that Mohr-Coulomb's sine of an angle means in triaxial states;
/// `side` is 1 in compression, -1 in extension.
double triaxial_slope(double sine, double side) {
  return 2.0 * sine / (std::numbers::sqrt3 * (3.0 - side * sine));
}

}  // namespace

void check(const DruckerPrager& material) {
  check(material.elastic);
  require(material.friction_angle >= 0.0 && material.friction_angle <= 89.999,
          "Drucker-Prager: friction_angle must lie in [0, 89.999] degrees, got ",
          material.friction_angle);
  require(material.dilatancy_angle >= 0.0 && material.dilatancy_angle <= material.friction_angle,
          "Drucker-Prager: dilatancy_angle must lie between 0 and the friction angle of ",
          material.friction_angle, " degrees, got ", material.dilatancy_angle);
  require(std::isfinite(material.cohesion) && material.cohesion >= 0.0,
          "Drucker-Prager: cohesion must not be negative (Pa), got ", material.cohesion);
}

DruckerPragerLaw::DruckerPragerLaw(const DruckerPrager& material)
    : shear(material.elastic.shear_modulus()), bulk(material.elastic.bulk_modulus()) {
  check(material);
  const double degree = std::numbers::pi / 180.0;
  const double sine = std::sin(material.friction_angle * degree);
  const double cosine = std::cos(material.friction_angle * degree);
  const double dilatancy = std::sin(material.dilatancy_angle * degree);
  if (material.fit == ConeFit::plane_strain) {
    // No flow across the plane: s_zz = -2 flow sqrt(J2), which leaves of the cone a line over the
    // mean stress in the plane, R = c cos(phi) - sin(phi) (s1 + s3) / 2; the same for the flow.
    flow = dilatancy / std::sqrt(9.0 + 3.0 * dilatancy * dilatancy);
    const double in_plane = std::sqrt(1.0 - 3.0 * flow * flow);  // R / sqrt(J2)
    cone = sine / (3.0 * (in_plane + flow * sine));
    strength = material.cohesion * cosine * (1.0 - 3.0 * cone * flow) / in_plane;
  } else {
    const double side = material.fit == ConeFit::compression ? 1.0 : -1.0;
    flow = triaxial_slope(dilatancy, side);
    cone = triaxial_slope(sine, side);
    strength = 6.0 * material.cohesion * cosine / (std::numbers::sqrt3 * (3.0 - side * sine));
  }
  per_excess = 1.0 / (shear + 9.0 * bulk * cone * flow);
  const double unreachable = 1e100;
  apex = cone > 0.0 ? std::min(strength / (3.0 * cone), unreachable) : unreachable;
  per_drop = 1.0 / (std::numbers::sqrt3 * shear);
}

SymmetricTensor DruckerPragerLaw::stress_and_slope(const SymmetricTensor& trial, double* state,
                                                   StressSlope& slope) const {
  return differentiate_return(*this, trial, state, slope);
}

}  // namespace lapilli
