#pragma once

#include <array>
#include <limits>
#include <vector>

#include "lapilli/materials/mohr_coulomb.hpp"

namespace lapilli {

struct TabulatedMohrCoulombLaw;

/// Mohr-Coulomb soil whose strength and dilatancy are tables of its plastic strain: hardening,
/// softening, and a critical state at which dilatancy ends. Not modelled: rate dependence, pore
/// pressure. What softens localises within a cell or two, and so does its energy.
struct TabulatedMohrCoulomb {
  static constexpr const char* kind = "tabulated_mohr_coulomb";
  using Law = TabulatedMohrCoulombLaw;
  LinearElastic elastic;
  std::vector<double> plastic_strain;           // rising from 0
  std::vector<double> friction_angle;           // degrees, one or one a plastic strain
  std::vector<double> dilatancy_angle = {0.0};  // degrees, likewise
  std::vector<double> cohesion = {0.0};         // Pa, likewise
  double tension_cutoff = std::numeric_limits<double>::infinity();  // Pa

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    LinearElastic::describe(self.elastic, visit);
    visit(Key("plastic_strain")
              .non_negative()
              .required()
              .length(2, 10000)
              .text("deviatoric plastic strains of the tables, rising from 0; linear in sines and "
                    "strength between them, constant after the last"),
          self.plastic_strain);
    visit(Key("friction_angle")
              .unit("degree")
              .range(0.0, 89.999)
              .required()
              .one_or_many()
              .length(1, 10000)
              .text("friction angle, one or one a plastic strain"),
          self.friction_angle);
    visit(Key("dilatancy_angle")
              .unit("degree")
              .range(0.0, 89.999)
              .one_or_many()
              .length(1, 10000)
              .text("dilatancy angle, at most the friction angle, one or one a plastic strain"),
          self.dilatancy_angle);
    visit(Key("cohesion")
              .unit("Pa")
              .non_negative()
              .one_or_many()
              .length(1, 10000)
              .text("shear strength without pressure, one or one a plastic strain"),
          self.cohesion);
    visit(Key("tension_cutoff")
              .unit("Pa")
              .non_negative()
              .or_infinite()
              .text("largest principal stress; the apex of the cone where it is lower"),
          self.tension_cutoff);
  }

  const LinearElastic& elastic_part() const { return elastic; }
  /// Integral of sqrt(2/3 e:e) of the rate e of deviatoric plastic strain.
  std::vector<StateVariable> state_variables() const { return {{"plastic_strain", "1"}}; }
};

/// Throws std::invalid_argument naming the first parameter that cannot be used.
void check(const TabulatedMohrCoulomb& material);

/// The exact return of Mohr-Coulomb with the strength and dilatancy of the plastic strain before
/// it.
struct TabulatedMohrCoulombLaw {
  static constexpr int states = 1;
  static constexpr bool yields = true, parts = true;

  explicit TabulatedMohrCoulombLaw(const TabulatedMohrCoulomb& material);

  template <class Real, int components>
  void return_stress(Real (&stress)[components], Real* state) const;
  SymmetricTensor stress_and_slope(const SymmetricTensor& trial, double* state,
                                   StressSlope& slope) const;
  template <class Real>
  Real parts_at(const Real* state) const {
    return numbers(state[0]).tension3;
  }

  /// sin(phi), 1 - sin(phi), 2 c cos(phi), sin(psi).
  using Entry = std::array<double, 4>;
  Entry entry(double plastic_strain) const;
  MohrCoulombNumbers<double> numbers(double plastic_strain) const;
  MohrCoulombNumbers<Double4> numbers(Double4 plastic_strain) const;

  std::vector<double> strains;
  std::vector<Entry> entries;
  double tension_cutoff, poissons_ratio, twice_shear;
};

template <class Real, int components>
void TabulatedMohrCoulombLaw::return_stress(Real (&s)[components], Real* state) const {
  Real drop[components];
  for (int c = 0; c < components; ++c) {
    drop[c] = s[c];
  }
  return_components(numbers(state[0]), s);
  for (int c = 0; c < components; ++c) {
    drop[c] = drop[c] - s[c];
  }
  const Real mean = (drop[0] + drop[1] + drop[2]) * (1.0 / 3.0);
  const Real x = drop[0] - mean, y = drop[1] - mean, z = drop[2] - mean;
  Real shear = drop[3] * drop[3];
  for (int c = 4; c < components; ++c) {
    shear = shear + drop[c] * drop[c];
  }
  const Real square = (2.0 / 3.0) * (x * x + y * y + z * z + 2.0 * shear);
  state[0] = state[0] + square_root(square) / twice_shear;
}

}  // namespace lapilli
