#pragma once

#include "lapilli/core/simd.hpp"
#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/return_point.hpp"
#include "lapilli/materials/stress_slope.hpp"

namespace lapilli {

struct ModifiedCamClayLaw;

/// Clay that hardens as it is compacted and softens as it dilates, up to a critical state: modified
/// Cam-clay (Roscoe & Burland 1968) with constant elastic moduli. Not modelled: moduli that grow
/// with pressure, rate dependence, pore pressure.
struct ModifiedCamClay {
  static constexpr const char* kind = "modified_cam_clay";
  using Law = ModifiedCamClayLaw;
  LinearElastic elastic;
  double critical_state_slope = 0.0;       // M of q = M p
  double plastic_compressibility = 0.0;    // lambda* - kappa*, volume strain over ln p
  double preconsolidation_pressure = 0.0;  // Pa, at the start

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    LinearElastic::describe(self.elastic, visit);
    visit(Key("critical_state_slope")
              .positive()
              .required()
              .text("M of q = M p at the critical state; 6 sin(phi) / (3 - sin(phi)) in triaxial "
                    "compression"),
          self.critical_state_slope);
    visit(Key("plastic_compressibility")
              .positive()
              .required()
              .text("plastic volume strain for a rise of the preconsolidation pressure by a factor "
                    "e: (lambda - kappa) / (1 + void ratio)"),
          self.plastic_compressibility);
    visit(Key("preconsolidation_pressure")
              .unit("Pa")
              .positive()
              .required()
              .text("pressure at which it yields at the start without shear"),
          self.preconsolidation_pressure);
  }

  const LinearElastic& elastic_part() const { return elastic; }
  /// Plastic volume strain, positive where it was compacted.
  std::vector<StateVariable> state_variables() const { return {{"plastic_compaction", "1"}}; }
};

/// Throws std::invalid_argument naming the first constant outside its range.
void check(const ModifiedCamClay& material);

/// Backward Euler return to q^2 / M^2 + p (p - pc) <= 0 with associated flow and
/// pc = pc0 exp(compaction / plastic_compressibility), exact in the hardening (Borja & Lee 1990).
/// The unknown is the multiplier; for each the pressure is the root of a monotone function.
struct ModifiedCamClayLaw {
  static constexpr int states = 1;
  static constexpr bool yields = true, parts = false;

  explicit ModifiedCamClayLaw(const ModifiedCamClay& material);

  template <class Real, int components>
  void return_stress(Real (&stress)[components], Real* state) const;
  SymmetricTensor stress_and_slope(const SymmetricTensor& trial, double* state,
                                   StressSlope& slope) const;

  /// Where a trial state ends: its pressure (positive in compression), the share of its shear that
  /// is left, and bulk modulus times the multiplier.
  template <class Real>
  struct Reached {
    Real pressure, share, multiplier;
  };
  Reached<double> reach(double pressure, double shear, double compaction) const;
  Reached<Double4> reach(Double4 pressure, Double4 shear, Double4 compaction) const;
  template <class Real>
  Reached<Real> reach(Real pressure, Real shear, Real compaction) const;

  /// Preconsolidation pressure, Pa, and its change with compaction; it stops falling at 2e-9 of
  /// that of the start.
  double preconsolidation(double compaction) const;
  double hardening(double compaction) const;

  double slope_square;  // M^2
  double bulk;          // Pa
  double shear_loss;    // 6 mu / (bulk M^2)
  double softness;      // plastic_compressibility
  double start;         // Pa
};

/// One more step of Newton's method, whose derivatives are those of the solution.
template <class Real>
ModifiedCamClayLaw::Reached<Real> ModifiedCamClayLaw::reach(Real pressure, Real shear,
                                                            Real compaction) const {
  const Reached<double> at = reach(pressure.value, shear.value, compaction.value);
  if (at.multiplier == 0.0) {
    return {pressure, as<Real>(1.0), as<Real>(0.0)};
  }
  const double p = at.pressure, s = at.multiplier, q = at.share * shear.value;
  const double whole = compaction.value + (pressure.value - p) / bulk;
  const double pc = preconsolidation(whole), per_compaction = hardening(whole);
  const double per_pressure = -per_compaction / bulk;  // d pc / d p
  const Real grown = (compaction - compaction.value) + (pressure - pressure.value) * (1.0 / bulk);
  const Real bound = as<Real>(pc) + grown * per_compaction;
  const Real flow = as<Real>(p) + s * (2.0 * p - bound) - pressure;
  const Real rest = shear * at.share;
  const Real yield = rest * rest * (1.0 / slope_square) + p * (p - bound);
  const double flow_p = 1.0 + s * (2.0 - per_pressure), flow_s = 2.0 * p - pc;
  const double yield_p = 2.0 * p - pc - p * per_pressure;
  const double yield_s = -2.0 * shear_loss * at.share * q * q / slope_square;
  const double determinant = flow_p * yield_s - flow_s * yield_p;
  const Real change_p = (yield * flow_s - flow * yield_s) * (1.0 / determinant);
  const Real change_s = (flow * yield_p - yield * flow_p) * (1.0 / determinant);
  const Real reached = as<Real>(p) + change_p, multiplier = as<Real>(s) + change_s;
  return {reached, as<Real>(1.0) / (1.0 + shear_loss * multiplier), multiplier};
}

template <class Real, int components>
void ModifiedCamClayLaw::return_stress(Real (&s)[components], Real* state) const {
  const Real mean = (s[0] + s[1] + s[2]) * (1.0 / 3.0);
  const Real x = s[0] - mean, y = s[1] - mean, z = s[2] - mean;
  Real both = s[3] * s[3];
  for (int c = 4; c < components; ++c) {
    both += s[c] * s[c];
  }
  const Real shear = square_root(1.5 * (x * x + y * y + z * z + 2.0 * both));
  const Real pressure = 0.0 - mean;
  const Reached<Real> at = reach(pressure, shear, state[0]);
  const auto plastic = at.multiplier > 0.0;
  s[0] = plastic ? at.share * x - at.pressure : s[0];
  s[1] = plastic ? at.share * y - at.pressure : s[1];
  s[2] = plastic ? at.share * z - at.pressure : s[2];
  for (int c = 3; c < components; ++c) {
    s[c] = plastic ? at.share * s[c] : s[c];
  }
  state[0] = plastic ? state[0] + (pressure - at.pressure) * (1.0 / bulk) : state[0];
}

}  // namespace lapilli
