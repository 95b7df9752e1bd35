#pragma once

#include "lapilli/core/points.hpp"
#include "lapilli/materials/newtonian.hpp"
#include "lapilli/peridynamics/flow_settings.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// The sound speed of a weakly compressible flow, m/s: what is set, or
/// max(factor sqrt(g beta dT l), 10 wall speed, 10 nu / l); with full gravity sqrt(g l) instead.
/// `wall_range` is the temperature difference between walls, K. Throws std::invalid_argument when
/// nothing in the scene gives one.
double choose_sound_speed(const Points& points, const WallSurface& walls,
                          const PeridynamicFlowSettings& settings, const Newtonian& fluid,
                          double wall_range);

}  // namespace lapilli
