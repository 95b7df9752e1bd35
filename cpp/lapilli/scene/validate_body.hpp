#pragma once

#include <string>
#include <vector>

#include "lapilli/scene/mistakes.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Gather what is wrong with the place, the motion and the material of one body, at `path`.
void validate_body(const Scene& scene, const Body& body, const std::string& path,
                   Mistakes& mistakes);

/// Hold a list to as many numbers as the grid has dimensions; an empty one stands for zeros.
void check_dimension(const Scene& scene, const std::vector<double>& list, const std::string& path);

}  // namespace lapilli
