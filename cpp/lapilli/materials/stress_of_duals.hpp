#pragma once

#include "lapilli/materials/dual.hpp"
#include "lapilli/materials/stress_slope.hpp"

namespace lapilli {

/// The values of a return whose code ran on duals, and its slopes; `state` follows.
inline SymmetricTensor stress_of_duals(const Dual<6> (&stress)[6], const Dual<6>* states, int count,
                                       double* state, StressSlope& slope) {
  SymmetricTensor reached;
  for (int c = 0; c < 6; ++c) {
    reached[c] = stress[c].value;
    for (int k = 0; k < 6; ++k) {
      slope(c, k) = stress[c].slope[static_cast<std::size_t>(k)];
    }
  }
  for (int k = 0; k < count; ++k) {
    state[k] = states[k].value;
  }
  return reached;
}

}  // namespace lapilli
