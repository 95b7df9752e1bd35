#pragma once

#include <vector>

#include "lapilli/mpm/heat/heat_obstacle.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The obstacles of [dynamics] that heat knows: those that exchange heat with what touches them,
/// and those that keep boundary conditions from it.
std::vector<HeatObstacle> heat_obstacles(const Scene& scene);

}  // namespace lapilli
