#pragma once

#include <span>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"

namespace lapilli {

/// What to warn of where a body is heated or cooled from within and so thin, in cells, that the
/// parabola of its temperature is not resolved. `span`: of all temperatures, K.
template <int Dim>
std::vector<Note> coarse_sources(std::span<const SurfaceFound> found,
                                 const HeatProblem<Dim>& problem, double span, double time);

}  // namespace lapilli
