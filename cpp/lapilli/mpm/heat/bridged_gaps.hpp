#pragma once

#include <string>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"

namespace lapilli {

/// Says where heat passes from one side of a gap to the other through common nodes: a slot in a
/// body, or a gap beside the place where bodies touch. In one dimension there is none.
template <int Dim>
std::vector<Note> bridged_gaps(const HeatProblem<Dim>& problem, const HeatPart<Dim>& part);

}  // namespace lapilli
