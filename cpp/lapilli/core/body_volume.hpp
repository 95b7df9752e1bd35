#pragma once

#include <optional>
#include <string>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// What the points of a body hold, beside what its shape holds.
struct BodyVolume {
  std::string name;
  Index points = 0;
  double volume = 0.0;             // m^dimension, of the points
  std::optional<double> of_shape;  // m^dimension; none for bodies known by points only
};

}  // namespace lapilli
