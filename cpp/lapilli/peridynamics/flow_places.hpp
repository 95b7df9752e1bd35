#pragma once

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// Throws RunError for a fluid point that has left the others or passed a wall: which, where, how
/// far.
template <int Dim>
void check_places(const Points& points, const WallSurface& walls, const Families& families,
                  const PointArray& velocity);

/// Part fluid points that lie in one place: shifting spreads points that are close, but these have
/// no direction to part in.
template <int Dim>
void part_coincident_points(Points& points, const WallSurface& walls, const Families& families);

}  // namespace lapilli
