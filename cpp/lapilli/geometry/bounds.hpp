#pragma once

#include <limits>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// An axis-aligned box that holds a shape; infinite along axes where the shape has no end.
struct Bounds {
  Vec3 lower = Vec3::Constant(-std::numeric_limits<double>::infinity());
  Vec3 upper = Vec3::Constant(std::numeric_limits<double>::infinity());
};

/// The place given by 0 to 3 numbers; missing coordinates are zero.
inline Vec3 place(const std::vector<double>& numbers) {
  Vec3 at = Vec3::Zero();
  for (std::size_t axis = 0; axis < numbers.size() && axis < 3; ++axis) {
    at[static_cast<int>(axis)] = numbers[axis];
  }
  return at;
}

}  // namespace lapilli
