#pragma once

#include <algorithm>

#include "lapilli/materials/dual.hpp"
#include "lapilli/materials/solid.hpp"
#include "lapilli/materials/stress_of_duals.hpp"

namespace lapilli {

// Returns after the long strains of a load step.

/// Into how many equal parts a law takes a strain. One return takes the direction of flow from the
/// end: of laws whose ellipse grows that is first order in the step (clay in drained compression,
/// ten steps: 6 % too much strain; two: 44 %).
template <class Law>
inline constexpr int parts_of_strain = 1;
template <>
inline constexpr int parts_of_strain<ModifiedCamClayLaw> = 8;

/// `stress` (c: 6) and `state` after the strain whose elastic stress is `whole`, part by part.
template <class Law, class Real>
void return_in_parts(const Law& law, Real (&stress)[6], const Real (&whole)[6], Real* state) {
  constexpr int parts = parts_of_strain<Law>;
  for (int part = 0; part < parts; ++part) {
    for (int c = 0; c < 6; ++c) {
      stress[c] += (1.0 / parts) * whole[c];
    }
    law.return_stress(stress, state);
  }
}

inline SymmetricTensor added(SymmetricTensor stress, const SymmetricTensor& change) {
  for (int c = 0; c < 6; ++c) {
    stress[c] += change[c];
  }
  return stress;
}

/// The stress that a law allows after a strain that would change `from` by the elastic stress
/// `change`; `state` follows.
inline SymmetricTensor return_along(const SolidLaw& law, const SymmetricTensor& from,
                                    const SymmetricTensor& change, double* state) {
  return std::visit(
      [&]<class Law>(const Law& one) {
        if constexpr (parts_of_strain<Law> == 1) {
          return return_stress(law, added(from, change), state);
        } else {
          double stress[6], whole[6];
          std::copy(from.components.begin(), from.components.end(), stress);
          std::copy(change.components.begin(), change.components.end(), whole);
          return_in_parts(one, stress, whole, state);
          return SymmetricTensor{stress[0], stress[1], stress[2], stress[3], stress[4], stress[5]};
        }
      },
      law);
}

/// The same, with the derivative of the stress to `change`.
inline SymmetricTensor slope_along(const SolidLaw& law, const SymmetricTensor& from,
                                   const SymmetricTensor& change, double* state,
                                   StressSlope& slope) {
  return std::visit(
      [&]<class Law>(const Law& one) {
        if constexpr (parts_of_strain<Law> == 1) {
          return stress_and_slope(law, added(from, change), state, slope);
        } else {
          using Real = Dual<6>;
          Real stress[6], whole[6], states[Law::states];
          for (int c = 0; c < 6; ++c) {
            stress[c] = as<Real>(from[c]);
            whole[c] = Real::variable(change[c], c);
          }
          for (int k = 0; k < Law::states; ++k) {
            states[k] = as<Real>(state[k]);
          }
          return_in_parts(one, stress, whole, states);
          return stress_of_duals(stress, states, Law::states, state, slope);
        }
      },
      law);
}

}  // namespace lapilli
