#pragma once

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Of a symmetric matrix.
template <int Size>
struct SymmetricModes {
  Vec<Size> eigenvalues;   ///< least first
  Mat<Size> eigenvectors;  ///< unit columns, in the same order
};

/// Compiled once: Eigen's solver takes the compiler seconds wherever it is read.
/// Size is 1, 2, 3 or 4; only the lower triangle of `matrix` is read.
template <int Size>
SymmetricModes<Size> symmetric_modes(const Mat<Size>& matrix);

}  // namespace lapilli
