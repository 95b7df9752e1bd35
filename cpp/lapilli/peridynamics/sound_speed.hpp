#pragma once

#include "lapilli/core/points.hpp"
#include "lapilli/peridynamics/flow_settings.hpp"
#include "lapilli/peridynamics/fluid.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

class PeridynamicHeat;

/// The sound speed of a weakly compressible flow, m/s: what is set, or
/// max(factor sqrt(g beta dT l), 10 wall speed, 10 nu / l); with full gravity sqrt(g l) instead.
/// The speed at which bodies start counts as one of a wall.
///
/// dT, unless set, is the span of what walls hold or what surrounds them, at any time, and of the
/// fluid where it is now; where walls give a flux q or bodies a source s, at least q l / k and
/// s l^2 / (8 k), as conduction would need. l, unless set, is the extent of the fluid along
/// gravity, or its least extent without gravity. `heat` may be null. Throws std::invalid_argument
/// when nothing in the scene gives a speed.
double choose_sound_speed(const Points& points, const WallSurface& walls,
                          const PeridynamicFlowSettings& settings, const Fluid& fluid,
                          const PeridynamicHeat* heat);

}  // namespace lapilli
