#pragma once

#include "lapilli/scene/mistakes.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Columns of the history are told by names: none is given twice, nor is that of a condition
/// without one ("convection 1") or of an entry that a balance has of its own ("source"). Adds a
/// mistake with both places for each.
void validate_names(const Scene& scene, Mistakes& mistakes);

}  // namespace lapilli
