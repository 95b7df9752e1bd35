#pragma once

#include <functional>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// A node at which two fields of bodies (see NodeFields) touch.
struct BodyTouch {
  Index node = 0;              // of the whole grid
  int first = 0, second = 0;   // fields
  double area = 0.0;           // m^(dim-1) of the surface, its share
  Vec3 normal = Vec3::Zero();  // of their common face, from the first to the second
  double beyond = 0.0;         // m, how far along the normal it lies; below 0: behind the node
};

using FindTouches = std::function<const std::vector<BodyTouch>&()>;

}  // namespace lapilli
