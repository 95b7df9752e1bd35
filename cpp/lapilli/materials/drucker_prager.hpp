#pragma once

#include <utility>

#include "lapilli/core/simd.hpp"
#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/return_point.hpp"
#include "lapilli/materials/stress_slope.hpp"

namespace lapilli {

/// Where the cone has the strength of Mohr-Coulomb: in plane strain, in triaxial compression (the
/// outer corners) or in triaxial extension (the inner ones).
enum class ConeFit { plane_strain, compression, extension };

template <>
struct Names<ConeFit> {
  static constexpr std::pair<ConeFit, const char*> values[] = {
      {ConeFit::plane_strain, "plane_strain"},
      {ConeFit::compression, "compression"},
      {ConeFit::extension, "extension"}};
};

struct DruckerPragerLaw;

/// Elastic, perfectly plastic soil with a smooth cone (Drucker & Prager 1952), cut in tension at
/// its apex. Tension is positive. Not modelled: hardening, rate dependence, pore pressure.
struct DruckerPrager {
  static constexpr const char* kind = "drucker_prager";
  using Law = DruckerPragerLaw;
  LinearElastic elastic;
  double friction_angle = 0.0;   // degrees, in [0, 90)
  double dilatancy_angle = 0.0;  // degrees, in [0, friction]
  double cohesion = 0.0;         // Pa
  ConeFit fit = ConeFit::plane_strain;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    LinearElastic::describe(self.elastic, visit);
    visit(Key("friction_angle").unit("degree").range(0.0, 89.999).required().text("friction angle"),
          self.friction_angle);
    visit(Key("dilatancy_angle")
              .unit("degree")
              .range(0.0, 89.999)
              .text("dilatancy angle, at most the friction angle"),
          self.dilatancy_angle);
    visit(Key("cohesion").unit("Pa").non_negative().text("shear strength without pressure"),
          self.cohesion);
    visit(Key("fit").text("where the cone has the strength of Mohr-Coulomb of these angles: "
                          "plane_strain, compression or extension (triaxial)"),
          self.fit);
  }

  const LinearElastic& elastic_part() const { return elastic; }
  /// Integral of sqrt(2/3 e:e) of the rate e of deviatoric plastic strain.
  std::vector<StateVariable> state_variables() const { return {{"plastic_strain", "1"}}; }
};

/// Throws std::invalid_argument naming the first constant outside its range.
void check(const DruckerPrager& material);

/// Return to sqrt(J2) + cone I1 <= strength with the flow of sqrt(J2) + flow I1, or to the apex.
/// Closed form (de Souza Neto, Peric & Owen 2008, section 8.3).
struct DruckerPragerLaw {
  static constexpr int states = 1;
  static constexpr bool yields = true, parts = true;

  explicit DruckerPragerLaw(const DruckerPrager& material);

  template <class Real, int components>
  void return_stress(Real (&stress)[components], Real* state) const;
  SymmetricTensor stress_and_slope(const SymmetricTensor& trial, double* state,
                                   StressSlope& slope) const;
  /// The mean stress of the apex, Pa.
  double parts_at(const auto* /*state*/) const { return apex; }

  double cone, flow, strength;  // 1, 1, Pa
  double shear, bulk;           // Pa
  double per_excess;            // 1 / (yield normal : elastic stress of the flow)
  double apex;                  // Pa; out of reach without friction
  double per_drop;              // plastic strain for a drop of sqrt(J2), 1/Pa
};

template <class Real, int components>
void DruckerPragerLaw::return_stress(Real (&s)[components], Real* state) const {
  const Real mean = (s[0] + s[1] + s[2]) * (1.0 / 3.0);
  const Real x = s[0] - mean, y = s[1] - mean, z = s[2] - mean;
  Real both = s[3] * s[3];
  for (int c = 4; c < components; ++c) {
    both += s[c] * s[c];
  }
  const Real size = square_root(0.5 * (x * x + y * y + z * z) + both);
  const Real excess = size + 3.0 * cone * mean - strength;
  const auto plastic = excess > 0.0;
  const Real multiplier = excess * per_excess;
  const Real on_cone = size - shear * multiplier;
  const auto at_apex = on_cone < 0.0;
  const Real rest = at_apex ? as<Real>(0.0) : on_cone;
  const Real level = at_apex ? as<Real>(apex) : mean - 3.0 * bulk * flow * multiplier;
  const Real scale = rest / (size > 0.0 ? size : as<Real>(1.0));
  s[0] = plastic ? level + scale * x : s[0];
  s[1] = plastic ? level + scale * y : s[1];
  s[2] = plastic ? level + scale * z : s[2];
  for (int c = 3; c < components; ++c) {
    s[c] = plastic ? scale * s[c] : s[c];
  }
  state[0] = plastic ? state[0] + per_drop * (size - rest) : state[0];
}

}  // namespace lapilli
