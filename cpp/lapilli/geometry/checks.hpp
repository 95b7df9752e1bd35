#pragma once

#include <cmath>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/bounds.hpp"

namespace lapilli {

/// Numbers as "(1, 2)", put into words only where a message is written: a check that holds in a
/// loop over points pays nothing. Refers to the numbers it was made of, so it is not to be kept.
class NumbersText {
 public:
  explicit NumbersText(std::span<const double> numbers) : numbers_(numbers) {}
  operator std::string() const { return message(*this); }  // NOLINT: stands for a text
  friend std::ostream& operator<<(std::ostream& out, const NumbersText& text);

 private:
  std::span<const double> numbers_;
};

/// "(1, 2)"
inline NumbersText text_of(const std::vector<double>& numbers) { return NumbersText(numbers); }
/// "(1, 2)" in two dimensions
inline NumbersText text_of(const Vec3& at, int dimension = 3) {
  return NumbersText({at.data(), static_cast<std::size_t>(dimension)});
}

/// Require `numbers` to be finite and to count `least` to `most`; the message says "annulus:
/// center".
void require_numbers(const std::vector<double>& numbers, std::size_t least, std::size_t most,
                     const char* shape, const char* member);
/// The same for row `row` of a list, "polygon: vertex 7".
void require_row(const std::vector<double>& numbers, std::size_t count, const char* shape,
                 const char* member, std::size_t row);

/// Require a finite number above zero.
void require_positive(double value, const char* shape, const char* member);

/// Require a grid of at least `least` dimensions for `shape`; `instead` names what to use.
void require_dimension(int dimension, int least, const char* shape, const char* instead);

}  // namespace lapilli
