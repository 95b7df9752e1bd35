#pragma once

#include <span>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/mpm/heat/condition_account.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"

namespace lapilli {

/// What to warn of on surfaces of bodies at rest. `account`: the heat of each condition; `span`: of
/// all temperatures, K.
template <int Dim>
std::vector<Note> surface_warnings(std::span<const SurfaceFound> found,
                                   const HeatProblem<Dim>& problem, const ConditionAccount& account,
                                   double span, double time);

}  // namespace lapilli
