#pragma once

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Throws std::invalid_argument, with the place in the scene file where there is one, for what
/// single keys cannot show: lists of another dimension than the grid, settings that contradict each
/// other, a physics without the material it needs. What depends on the points is checked by
/// build().
void validate(const Scene& scene);

}  // namespace lapilli
