#pragma once

#include <memory>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Add the motion that bodies of a scene are given, and the bound on steps where what it moves past
/// matters to the heat among `physics`.
template <int Dim>
void add_motion(const Scene& scene, Points& points, std::vector<std::unique_ptr<Physics>>& physics);

}  // namespace lapilli
