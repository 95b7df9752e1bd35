#pragma once

#include "lapilli/mpm/heat/heat_problem.hpp"

namespace lapilli {

/// Areas of the outermost points, for laws that act on points (PB). A point owns the faces of its
/// box beyond which no other point lies; each counts with the component of the point's outward
/// normal across it, so that a staircase has the area of the line it follows. The entries' `node`
/// is the row of the point, its position the middle of its free faces.
template <int Dim>
NodalAreas<Dim> particle_areas(const Points& points, const HeatProblem<Dim>& problem);

}  // namespace lapilli
