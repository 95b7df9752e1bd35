#pragma once

#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"

namespace lapilli {

/// What to warn of where bodies that conduct differently share nodes (`together`: numbers of those
/// that do, by field): one slope on both sides of a face within a cell, the mean of both conducts.
/// One sentence, on the worst pair; empty where none is twice the other.
std::vector<Note> common_nodes(const std::vector<std::vector<std::size_t>>& together,
                               const std::vector<HeatBody>& bodies, double cell_size);

/// The same of bodies in contact, with temperatures of their own: where one conducts much better.
std::vector<Note> unlike_contacts(const std::vector<std::vector<std::size_t>>& together,
                                  const std::vector<HeatBody>& bodies, double cell_size);

}  // namespace lapilli
