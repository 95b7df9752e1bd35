#pragma once

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Throws std::invalid_argument, with the place in the file, for a [peridynamics] that contradicts
/// the rest of the scene: another method's section, prescribed motion, materials that are missing
/// or differ between bodies. Nothing where there is no such section.
void validate_peridynamics(const Scene& scene);

}  // namespace lapilli
