#pragma once

#include <vector>

#include "lapilli/geometry/bounds.hpp"
#include "lapilli/geometry/random.hpp"

namespace lapilli {

/// Uniform points of a box; the same ones each time. Coordinates past `dimension` are zero.
inline std::vector<Vec3> random_points(int count, int dimension, const Bounds& box,
                                       std::uint64_t seed = 7) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int k = 0; k < count; ++k) {
    Vec3 x = Vec3::Zero();
    for (int axis = 0; axis < dimension; ++axis) {
      x[axis] = random.uniform(box.lower[axis], box.upper[axis]);
    }
    points.push_back(x);
  }
  return points;
}

}  // namespace lapilli
