#pragma once

#include <string>
#include <vector>

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The scene with absolute names of its input files, which start from the folder of its scene file
/// where they are relative.
Scene with_resolved_files(Scene scene);

/// The names of the input files of a scene, in its order.
std::vector<std::string> input_files(const Scene& scene);

}  // namespace lapilli
