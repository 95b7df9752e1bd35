#pragma once

#include <string>
#include <vector>

#include "lapilli/scene/scene.hpp"

namespace lapilli {

class Points;

/// What the points of a body hold, beside what its shape holds.
struct BodyVolume {
  std::string name;
  Index points = 0;
  double volume = 0.0;             // m^dimension, of the points
  std::optional<double> of_shape;  // m^dimension; none for bodies known by points only
};

/// The volumes of all bodies of a built scene, at its start.
std::vector<BodyVolume> body_volumes(const Scene& scene, const Points& points);

/// A warning for each body whose points hold over 0.1 % more or less than its shape.
std::vector<std::string> volume_warnings(const std::vector<BodyVolume>& volumes, int dimension);

}  // namespace lapilli
