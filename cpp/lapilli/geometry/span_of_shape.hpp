#pragma once

#include <cmath>
#include <string>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// " (x 0.02 to 0.04, y 0 to 0.01 m)": how far a shape reaches along the axes where it ends.
inline std::string span_of_shape(const Shape& shape) {
  const Bounds box = bounds(shape);
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isfinite(box.lower[axis]) && std::isfinite(box.upper[axis]) &&
        box.upper[axis] > box.lower[axis]) {
      text += message(text.empty() ? " (" : ", ", "xyz"[axis], " ", box.lower[axis], " to ",
                      box.upper[axis]);
    }
  }
  return text.empty() ? text : text + " m)";
}

}  // namespace lapilli
