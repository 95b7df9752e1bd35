#pragma once

#include <string>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/dynamics_problem.hpp"

namespace lapilli {

/// Faces of the grid act on their nodes, and so on bodies up to a cell away. Says which bodies of
/// the start lie so near a face without touching it, which will fall onto one, and which obstacles
/// run along a face on which they end.
template <int Dim>
std::vector<Note> early_stops(const DynamicsData<Dim>& data,
                              const std::vector<DynamicsBody>& bodies);

}  // namespace lapilli
