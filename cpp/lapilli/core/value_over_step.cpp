#include "lapilli/core/value_over_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lapilli {

void evaluate_over(const Value& value, std::span<const Vec3> position,
                   std::span<const double> state, double from, double to,
                   std::span<double> values) {
  if (value.is_function()) {
    value.evaluate(position, state, 0.5 * (from + to), values);
  } else {
    std::fill(values.begin(), values.end(), value.mean(from, to));
  }
}

bool jumps_within(const Value& value, double from, double to) {
  const double before = std::nextafter(from, -std::numeric_limits<double>::infinity());
  return value.next_jump(before) < to;
}

}  // namespace lapilli
