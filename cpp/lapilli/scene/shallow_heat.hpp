#pragma once

#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// What to warn of where a run ends before the heat that surfaces exchange is deep enough for the
/// cells: one sentence, on the body where it is least so.
std::vector<Note> shallow_heat(const Scene& scene);

}  // namespace lapilli
