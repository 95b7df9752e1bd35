#pragma once

#include <numeric>

#include "lapilli/geometry/fill.hpp"

namespace lapilli {

/// Area or volume of all points.
inline double total(const FilledPoints& points) {
  return std::accumulate(points.volume.begin(), points.volume.end(), 0.0);
}

inline Vec3 centroid(const FilledPoints& points) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (int axis = 0; axis < points.dimension; ++axis) {
      sum[axis] += points.volume[k] * points.position[k * points.dimension + axis];
    }
  }
  return sum / total(points);
}

}  // namespace lapilli
