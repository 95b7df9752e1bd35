#pragma once

#include "lapilli/mpm/heat/heat_settings.hpp"

namespace lapilli {

/// Whether settings ask for the operators of points even where the shapes of bodies at rest are
/// known: who sets the nodal normals, exchange at the start of the step, another method or another
/// transfer.
bool asks_for_points(const HeatSettings& settings);

}  // namespace lapilli
