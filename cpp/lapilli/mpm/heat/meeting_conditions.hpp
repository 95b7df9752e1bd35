#pragma once

#include <span>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/mpm/heat/condition_account.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/surface/cube_parts.hpp"

namespace lapilli {

/// Where conditions that hold the surface, or exchange with it, meet: how long that edge is by pair
/// of them. `pieces` by condition, `coefficient` (W/(m^2 K)) too.
template <int Dim>
std::vector<SurfaceFound::Meeting> find_meetings(
    const std::vector<std::vector<SurfacePiece<Dim>>>& pieces, std::span<const double> coefficient,
    double cell_size);

/// What to warn of where conditions of different temperature meet: heat passes straight from one to
/// the other within conductivity / coefficient of that edge, a point where cells are larger. `heat`
/// up to `time`; `found` by body.
std::vector<Note> crossing_heat(std::span<const SurfaceFound> found,
                                const std::vector<HeatBody>& bodies, const HeatSettings& settings,
                                const ConditionAccount& heat, double cell_size, double time);

/// What to warn of where a flux ends beside a condition that comes near to holding the surface: of
/// what enters by that end, what passes straight to the other depends on where cells end it.
std::vector<Note> fluxes_beside(std::span<const SurfaceFound> found, const HeatSettings& settings,
                                const ConditionAccount& heat);

}  // namespace lapilli
