#pragma once

#include "lapilli/scene/check.hpp"
#include "lapilli/scene/memory.hpp"

namespace lapilli {

/// Say what the steps of a scene that is too large to be built are like, and how long they take:
/// from two copies of it with coarser cells, since steps go as a power of the cell size. A scene
/// that has no coarser copy gets a note. `report` has its points.
void estimate_steps(const Scene& scene, CheckReport& report);

}  // namespace lapilli
