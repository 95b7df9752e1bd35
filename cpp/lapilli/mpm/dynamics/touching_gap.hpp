#pragma once

namespace lapilli {

/// Cells: a gap of no more is none to what adheres, for what rests swings by its own weight.
inline constexpr double touching_gap = 0.05;

}  // namespace lapilli
