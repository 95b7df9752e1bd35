#pragma once

#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// How far heat comes into a material within a time (s), m: the root of diffusivity x time.
double depth_of_heat(const Thermal& thermal, double time);

/// What to warn of where a run ends before the heat that surfaces exchange is deep enough for the
/// cells: one sentence, on the body where it is least so.
std::vector<Note> shallow_heat(const Scene& scene);

}  // namespace lapilli
