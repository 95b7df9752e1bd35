#pragma once

#include <span>
#include <string>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// What output and Python see of a quantity that points carry: one row per point, in current order.
struct Field {
  std::string name;          // "temperature"
  std::string unit;          // "K"
  int components = 1;        // 1 scalar, dim vector, dim*dim or 6 tensor (row-major)
  std::span<double> values;  // rows x components, row-major; owned by the physics
};

}  // namespace lapilli
