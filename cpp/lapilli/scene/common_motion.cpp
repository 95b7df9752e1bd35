#include "lapilli/scene/common_motion.hpp"

#include <algorithm>

#include "lapilli/geometry/rigid_motion.hpp"

namespace lapilli {

bool has_motion(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return body.motion.has_value(); });
}

bool has_moving_points(const Scene& scene) { return has_motion(scene) || scene.dynamics; }

std::optional<Motion> common_motion(const Scene& scene) {
  if (scene.bodies.empty()) {
    return std::nullopt;
  }
  const std::optional<Motion>& first = scene.bodies.front().motion;
  const bool shared = first && !scene.dynamics && is_rigid(*first) &&
                      std::all_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) {
                        return body.motion && is_same(*body.motion, *first);
                      });
  return shared ? first : std::nullopt;
}

}  // namespace lapilli
