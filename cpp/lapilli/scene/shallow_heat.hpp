#pragma once

#include <string>
#include <vector>

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// What to warn of where a run ends before the heat that surfaces exchange is deep enough for the
/// cells: one sentence, on the body where it is least so.
std::vector<std::string> shallow_heat(const Scene& scene);

}  // namespace lapilli
