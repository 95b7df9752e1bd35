#include "lapilli/materials/mohr_coulomb.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lapilli/core/require.hpp"
#include "lapilli/materials/principal.hpp"

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

MohrCoulombReturn::MohrCoulombReturn(const MohrCoulomb& material) {
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

SymmetricTensor return_stress(const MohrCoulombReturn& material, const SymmetricTensor& trial) {
  SymmetricTensor stress = trial;
  return_stresses(material, stress.components.data(), 1, 1);
  return stress;
}

void return_stresses(const MohrCoulombReturn& material, double* stress, int stride, int rows) {
  const MohrCoulombReturn m = material;
  for_quads(0, rows, [&m, stress, stride]<class Real>(int row) {
    Real s[6];
    for (int c = 0; c < 6; ++c) {
      s[c] = load<Real>(stress + c * stride + row);
    }
    const auto sorted = [&m](Real t1, Real t2, Real t3) { return return_sorted(m, t1, t2, t3); };
    apply_full(sorted, s[0], s[1], s[2], s[3], s[4], s[5]);
    for (int c = 0; c < 6; ++c) {
      store(stress + c * stride + row, s[c]);
    }
  });
}

void return_stresses_plane_strain(const MohrCoulombReturn& material, double* stress, int stride,
                                  int rows) {
  const MohrCoulombReturn m = material;
  for_quads(0, rows, [&m, stress, stride]<class Real>(int row) {
    Real s[4];
    for (int c = 0; c < 4; ++c) {
      s[c] = load<Real>(stress + c * stride + row);
    }
    const auto sorted = [&m](Real t1, Real t2, Real t3) { return return_sorted(m, t1, t2, t3); };
    apply_plane(sorted, s[0], s[1], s[2], s[3]);
    for (int c = 0; c < 4; ++c) {
      store(stress + c * stride + row, s[c]);
    }
  });
}

}  // namespace lapilli
