#pragma once

#include <functional>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// A surface as the zero set of a signed distance (m).
struct LevelSet {
  std::function<double(const Vec3&)> distance;
  std::function<Vec3(const Vec3&)> normal;  // gradient of the distance, unit
};

}  // namespace lapilli
