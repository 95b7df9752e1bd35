#pragma once

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The scene with the names of its input files starting from the folder of its scene file, where
/// they are relative.
Scene with_resolved_files(Scene scene);

}  // namespace lapilli
