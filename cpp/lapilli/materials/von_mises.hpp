#pragma once

#include <cstddef>
#include <vector>

#include "lapilli/core/simd.hpp"
#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/return_point.hpp"
#include "lapilli/materials/stress_slope.hpp"

namespace lapilli {

struct VonMisesLaw;

/// Elastic, plastic metal or clay: von Mises' yield stress with isotropic hardening, tabulated over
/// the equivalent plastic strain. Not modelled: softening, kinematic hardening, rate dependence.
struct VonMises {
  static constexpr const char* kind = "von_mises";
  using Law = VonMisesLaw;
  LinearElastic elastic;
  std::vector<double> yield_stress;    // Pa, in uniaxial tension
  std::vector<double> plastic_strain;  // at which; empty with one yield stress

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    LinearElastic::describe(self.elastic, visit);
    visit(Key("yield_stress")
              .unit("Pa")
              .positive()
              .required()
              .one_or_many()
              .length(1, 10000)
              .text("uniaxial yield stress: a number, or one for each plastic strain, not falling"),
          self.yield_stress);
    visit(Key("plastic_strain")
              .non_negative()
              .length(0, 10000)
              .text("equivalent plastic strains of the yield stresses, rising from 0; linear "
                    "between them, constant after the last"),
          self.plastic_strain);
  }

  const LinearElastic& elastic_part() const { return elastic; }
  /// Integral of sqrt(2/3 e:e) of the rate e of plastic strain.
  std::vector<StateVariable> state_variables() const { return {{"plastic_strain", "1"}}; }
};

/// Throws std::invalid_argument naming the first parameter that cannot be used.
void check(const VonMises& material);

/// Radial return to the tabulated yield stress, exact: sqrt(3/2 s:s) - 3 mu dp = yield(p + dp).
struct VonMisesLaw {
  static constexpr int states = 1;
  static constexpr bool yields = true, parts = false;

  explicit VonMisesLaw(const VonMises& material);

  template <class Real, int components>
  void return_stress(Real (&stress)[components], Real* state) const;
  SymmetricTensor stress_and_slope(const SymmetricTensor& trial, double* state,
                                   StressSlope& slope) const;

  /// Of the table: yield stress = start + slope (plastic strain - from).
  template <class Real>
  struct Line {
    Real from, start, slope;
  };
  /// The line on which a trial stress of size q, begun at plastic strain p, ends.
  Line<double> line(double q, double p) const;
  Line<Double4> line(Double4 q, Double4 p) const;
  template <class Real>
  Line<Real> line(Real q, Real p) const {
    const Line<double> found = line(q.value, p.value);
    return {as<Real>(found.from), as<Real>(found.start), as<Real>(found.slope)};
  }

  double three_shear;  // 3 mu, Pa
  std::vector<Line<double>> lines;
};

template <class Real, int components>
void VonMisesLaw::return_stress(Real (&s)[components], Real* state) const {
  const Real mean = (s[0] + s[1] + s[2]) * (1.0 / 3.0);
  const Real x = s[0] - mean, y = s[1] - mean, z = s[2] - mean;
  Real shear = s[3] * s[3];
  for (int c = 4; c < components; ++c) {
    shear += s[c] * s[c];
  }
  const Real size = square_root(1.5 * (x * x + y * y + z * z + 2.0 * shear));
  const Line<Real> at = line(size, state[0]);
  const Real excess = size - at.start - at.slope * (state[0] - at.from);
  const auto plastic = excess > 0.0;
  const Real strain = excess / (three_shear + at.slope);
  const Real scale = 1.0 - three_shear * strain / (plastic ? size : as<Real>(1.0));
  s[0] = plastic ? mean + scale * x : s[0];
  s[1] = plastic ? mean + scale * y : s[1];
  s[2] = plastic ? mean + scale * z : s[2];
  for (int c = 3; c < components; ++c) {
    s[c] = plastic ? scale * s[c] : s[c];
  }
  state[0] = plastic ? state[0] + strain : state[0];
}

}  // namespace lapilli
