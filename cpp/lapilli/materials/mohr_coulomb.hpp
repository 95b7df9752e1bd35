#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

#include "lapilli/core/simd.hpp"
#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/principal.hpp"
#include "lapilli/materials/return_point.hpp"
#include "lapilli/materials/stress_slope.hpp"

namespace lapilli {

struct MohrCoulombLaw;

/// Elastic, perfectly plastic soil: Mohr-Coulomb with its own dilatancy angle, closed in tension by
/// a Rankine cut-off (at the apex unless a lower one is given). Tension is positive.
/// Not modelled: hardening, rate dependence, pore pressure.
struct MohrCoulomb {
  static constexpr const char* kind = "mohr_coulomb";
  using Law = MohrCoulombLaw;
  LinearElastic elastic;
  double friction_angle = 0.0;                                      // degrees, in [0, 90)
  double dilatancy_angle = 0.0;                                     // degrees, in [0, friction]
  double cohesion = 0.0;                                            // Pa
  double tension_cutoff = std::numeric_limits<double>::infinity();  // Pa, largest principal stress

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
    visit(Key("tension_cutoff")
              .unit("Pa")
              .non_negative()
              .or_infinite()
              .text("largest principal stress; the apex of the cone where it is lower"),
          self.tension_cutoff);
  }

  const LinearElastic& elastic_part() const { return elastic; }
  std::vector<StateVariable> state_variables() const { return {}; }
};

/// Throws std::invalid_argument naming the first constant outside its range.
void check(const MohrCoulomb& material);

/// What the return mapping needs of the angles and the cohesion: of a material, or, where they
/// change with its state, of one point (double) or four (Double4).
template <class Number>
struct MohrCoulombNumbers {
  /// From sin(phi), 1 - sin(phi) (without cancellation), 2 c cos(phi), sin(psi), and the cut-off.
  MohrCoulombNumbers(Number sine, Number remainder, Number cohesive, Number dilatancy,
                     double tension_cutoff, double poissons_ratio);

  Number above, below, strength;   // (1 + sin phi) s1 - (1 - sin phi) s3 <= strength
  Number flow1, flow2, flow3;      // elastic stress of the plastic flow over 2 mu, sorted
  Number flow_left, flow_right;    // its mean over the two stresses that meet on an edge
  Number plane, left, right;       // 1 / (yield normal : flow) on the plane and the edges
  Number tension, tension3;        // cut-off, and s3 where it meets the cone
  double poissons_ratio, lateral;  // nu, nu / (1 - nu)
};

/// The return mapping, its constants made once a material.
struct MohrCoulombLaw : MohrCoulombNumbers<double> {
  static constexpr int states = 0;
  static constexpr bool yields = true, parts = true;

  explicit MohrCoulombLaw(const MohrCoulomb& material);

  template <class Real, int components>
  void return_stress(Real (&stress)[components], Real* state) const;
  SymmetricTensor stress_and_slope(const SymmetricTensor& trial, double* state,
                                   StressSlope& slope) const;
  /// Where all three principal stresses are at what the material bears in tension, Pa.
  double parts_at(const auto* /*state*/) const { return tension3; }
};

/// Sorted principal stresses after the return, s1 >= s2 >= s3, Pa.
template <class Real>
struct PrincipalStress {
  Real s1, s2, s3;
};

/// A constant, or what already is a Real, as one.
template <class Real>
inline Real lift(double value) {
  return as<Real>(value);
}
template <class Real>
requires(!std::is_same_v<Real, double>) inline Real lift(Real value) { return value; }

/// Exact return of a sorted elastic trial: plane, two edges, cut-off face, edge, corner, and the
/// line and corners where the cut-off meets the cone (with no cut-off given all of these fall
/// together in the apex). Closed form, no iteration, no branch; Real is double, Double4 or a Dual.
/// Regions by the sign of the multipliers as in Clausen, Damkilde & Andersen (2006), Comput.
/// Struct. 85:1795.
template <class Number, class Real>
inline PrincipalStress<Real> return_sorted(const MohrCoulombNumbers<Number>& m, Real t1, Real t2,
                                           Real t3) {
  const Real tension = lift<Real>(m.tension), tension3 = lift<Real>(m.tension3);
  const Real yield = m.above * t1 - m.below * t3 - m.strength;
  const Real plane = yield * m.plane;
  const Real p1 = t1 - m.flow1 * plane;
  const Real p2 = t2 - m.flow2 * plane;
  const Real p3 = t3 - m.flow3 * plane;

  // Left edge (s1 = s2) and right edge (s2 = s3): both multipliers at once through the mean stress.
  const Real mean12 = 0.5 * (t1 + t2);
  const Real left = (m.above * mean12 - m.below * t3 - m.strength) * m.left;
  const Real l12 = mean12 - m.flow_left * left;
  const Real l3 = t3 - m.flow3 * left;
  const Real mean23 = 0.5 * (t2 + t3);
  const Real right = (m.above * t1 - m.below * mean23 - m.strength) * m.right;
  const Real r1 = t1 - m.flow1 * right;
  const Real r23 = mean23 - m.flow_right * right;

  const auto past_left = p1 < p2;
  const auto past_right = p2 < p3;
  const auto face_sorted = p2 >= p3;
  const auto left_sorted = l12 >= l3;
  const auto on_left = past_left & (face_sorted | left_sorted);
  const auto plastic = yield > 0.0;
  const Real e1 = past_right ? r1 : p1, e2 = past_right ? r23 : p2, e3 = past_right ? r23 : p3;
  const Real c1 = on_left ? l12 : e1, c2 = on_left ? l12 : e2, c3 = on_left ? l3 : e3;
  const Real s1 = plastic ? c1 : t1, s2 = plastic ? c2 : t2, s3 = plastic ? c3 : t3;

  // Cut-off alone: face, edge, corner.
  const Real excess = t1 - tension;
  const Real face2 = t2 - m.lateral * excess;
  const Real face3 = t3 - m.lateral * excess;
  const Real edge3 = t3 - m.poissons_ratio * (2.0 * (mean12 - tension));
  const Real capped3 = edge3 > tension ? tension : edge3;
  const auto on_edge = face2 > tension;
  const Real k2 = on_edge ? tension : face2;
  const Real k3 = on_edge ? capped3 : face3;

  // Cut-off and cone together: no plastic strain along the middle axis between the corners.
  const Real middle = t2 + m.poissons_ratio * (tension + tension3 - t1 - t3);
  const Real below_top = middle > tension ? tension : middle;
  const Real j2 = below_top < tension3 ? tension3 : below_top;

  const auto inside_cone = k3 >= tension3;
  const auto cut = s1 > tension;
  const Real h2 = inside_cone ? k2 : j2, h3 = inside_cone ? k3 : tension3;
  return {cut ? tension : s1, cut ? h2 : s2, cut ? h3 : s3};
}

/// The same of a stress given by its components.
template <class Number, class Real, int components>
inline void return_components(const MohrCoulombNumbers<Number>& m, Real (&s)[components]) {
  const auto sorted = [&m](Real t1, Real t2, Real t3) { return return_sorted(m, t1, t2, t3); };
  if constexpr (components == 4) {
    apply_plane(sorted, s[0], s[1], s[2], s[3]);
  } else {
    apply_full(sorted, s[0], s[1], s[2], s[3], s[4], s[5]);
  }
}

template <class Real, int components>
void MohrCoulombLaw::return_stress(Real (&stress)[components], Real* /*state*/) const {
  return_components(*this, stress);
}

template <class Number>
MohrCoulombNumbers<Number>::MohrCoulombNumbers(Number sine, Number remainder, Number cohesive,
                                               Number dilatancy, double tension_cutoff, double nu) {
  above = 1.0 + sine;
  below = remainder;
  strength = cohesive;

  // Elastic stress of the flow direction (1 + sin psi, 0, sin psi - 1), over 2 mu.
  const Number volumetric = 2.0 * dilatancy * nu / (1.0 - 2.0 * nu);
  flow1 = volumetric + 1.0 + dilatancy;
  flow2 = volumetric;
  flow3 = volumetric + dilatancy - 1.0;
  flow_left = 0.5 * (flow1 + flow2);
  flow_right = 0.5 * (flow2 + flow3);
  plane = 1.0 / (above * flow1 - below * flow3);
  left = 1.0 / (above * flow_left - below * flow3);
  right = 1.0 / (above * flow1 - below * flow_right);

  // Without friction the cone has no apex: the cut-off is then out of reach, not infinite.
  const Number unreachable = as<Number>(1e100), given = as<Number>(std::min(tension_cutoff, 1e100));
  const auto has_apex = sine > 0.0;
  const Number apex =
      has_apex ? strength / (2.0 * (has_apex ? sine : as<Number>(1.0))) : unreachable;
  tension = given < apex ? given : apex;
  const Number meeting = (above * tension - strength) / below;
  tension3 = meeting < tension ? meeting : tension;
  poissons_ratio = nu;
  lateral = nu / (1.0 - nu);
}

}  // namespace lapilli
