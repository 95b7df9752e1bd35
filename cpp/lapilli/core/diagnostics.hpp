#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/simulation.hpp"

namespace lapilli {

/// Named numbers of every physics, "flow/velocity noise", of the state that fields() shows.
std::vector<std::pair<std::string, double>> diagnostics_of(Simulation& simulation);

}  // namespace lapilli
