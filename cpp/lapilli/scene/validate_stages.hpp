#pragma once

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Throws std::invalid_argument with place in the file, number and name of the first stage of a
/// scene that cannot be, or whose keys do not fit together.
void validate_stages(const Scene& scene);

}  // namespace lapilli
