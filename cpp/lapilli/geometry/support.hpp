#pragma once

#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// The least box that holds a shape.
struct TightBounds {
  Bounds box;             // infinite along axes where the shape has no end
  bool is_tight = false;  // false for images, intersections and differences: may be too large
};

TightBounds tight_bounds(const Shape& shape);

}  // namespace lapilli
