#pragma once

#include <optional>

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Whether a motion is prescribed for a body.
bool has_motion(const Scene& scene);

/// Whether a prescribed motion or dynamics move points.
bool has_moving_points(const Scene& scene);

/// The one prescribed rigid motion that all bodies share; none where they do not, or nothing moves.
std::optional<Motion> common_motion(const Scene& scene);

}  // namespace lapilli
