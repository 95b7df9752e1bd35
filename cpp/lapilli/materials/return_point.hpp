#pragma once

#include <algorithm>
#include <cstddef>

#include "lapilli/core/simd.hpp"
#include "lapilli/materials/symmetric_tensor.hpp"

namespace lapilli {

/// The stress that a law allows for an elastic trial stress at one point; `state` follows.
template <class Law>
SymmetricTensor return_point(const Law& law, const SymmetricTensor& trial, double* state) {
  double stress[6];
  std::copy(trial.components.begin(), trial.components.end(), stress);
  law.return_stress(stress, state);
  return {stress[0], stress[1], stress[2], stress[3], stress[4], stress[5]};
}

/// Return `rows` trial stresses in place: component c of row k is stress[c * stride + k], state
/// variable v of row k is state[v * stride + k]. Four components in plane strain (xx, yy, zz, xy),
/// six in space (xx, yy, zz, xy, yz, xz).
template <int components, class Law>
void return_stresses(const Law& law, double* stress, double* state, int stride, int rows) {
  const auto pitch = static_cast<std::ptrdiff_t>(stride);
  for_quads(0, rows, [&law, stress, state, pitch]<class Real>(int row) {
    Real s[components], v[std::max(1, Law::states)];
    for (int c = 0; c < components; ++c) {
      s[c] = load<Real>(stress + c * pitch + row);
    }
    for (int k = 0; k < Law::states; ++k) {
      v[k] = load<Real>(state + k * pitch + row);
    }
    law.return_stress(s, v);
    for (int c = 0; c < components; ++c) {
      store(stress + c * pitch + row, s[c]);
    }
    for (int k = 0; k < Law::states; ++k) {
      store(state + k * pitch + row, v[k]);
    }
  });
}

}  // namespace lapilli
