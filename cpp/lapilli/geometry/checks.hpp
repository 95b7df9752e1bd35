#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/bounds.hpp"

namespace lapilli {

/// "(1, 2)"
std::string text_of(const std::vector<double>& numbers);
/// "(1, 2)" in two dimensions
std::string text_of(const Vec3& at, int dimension = 3);

/// Require `numbers` to be finite and to count `least` to `most`; the message says "annulus:
/// center".
void require_numbers(const std::vector<double>& numbers, std::size_t least, std::size_t most,
                     const char* shape, const char* member);

/// Require a finite number above zero.
void require_positive(double value, const char* shape, const char* member);

/// Require a grid of at least `least` dimensions for `shape`; `instead` names what to use.
void require_dimension(int dimension, int least, const char* shape, const char* instead);

}  // namespace lapilli
