#pragma once

#include <optional>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/geometry/prescribed_motion.hpp"

namespace lapilli {

/// What a step of prescribed motion may be, where it matters to the result: no point goes further
/// than this share of a cell, nothing turns by more than this share of a turn.
constexpr double cells_in_a_step = 0.25, turns_in_a_step = 1.0 / 40.0;

/// The longest such step, s, of points where they are at the start; infinite where nothing moves.
/// `motions` by body.
template <int Dim>
double step_of_motion(const Points& points, const std::vector<std::optional<Motion>>& motions,
                      double cell);

}  // namespace lapilli
