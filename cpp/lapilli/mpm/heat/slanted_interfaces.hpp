#pragma once

#include <span>
#include <string>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"

namespace lapilli {

/// What to warn of where bodies of different conductivity touch at an angle to the grid: one field
/// of temperature cannot bend along such an interface, and the poorer conductor acts as if it were
/// thinner. `found` by body. One sentence, on the worst body; empty where none is off by 2 %.
std::vector<Note> slanted_interfaces(std::span<const SurfaceFound> found,
                                     const std::vector<HeatBody>& bodies, double cell_size);

}  // namespace lapilli
