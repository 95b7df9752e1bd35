#include "lapilli/scene/build_motion.hpp"

#include <cmath>
#include <limits>

#include "lapilli/geometry/pace_of_motion.hpp"
#include "lapilli/geometry/prescribed_motion.hpp"
#include "lapilli/geometry/step_of_motion.hpp"
#include "lapilli/mpm/heat/follows_changes.hpp"
#include "lapilli/mpm/heat/heat_in_body_frame.hpp"
#include "lapilli/scene/common_motion.hpp"

namespace lapilli {

template <int Dim>
void add_motion(const Scene& scene, Points& points,
                std::vector<std::unique_ptr<Physics>>& physics) {
  std::vector<std::optional<Motion>> motions;
  for (const Body& body : scene.bodies) {
    motions.push_back(body.motion);
  }
  // Heat in the frame of the bodies does not ask where they are, unless its conditions do.
  const auto* in_frame =
      physics.size() == 1 ? dynamic_cast<HeatInBodyFrame<Dim>*>(physics.front().get()) : nullptr;
  const bool matters = scene.heat && (in_frame == nullptr || in_frame->depends_on_place());
  const double longest = matters ? step_of_motion<Dim>(points, motions, scene.grid.cell)
                                 : std::numeric_limits<double>::infinity();
  for (const auto& one : physics) {
    if (auto* follower = dynamic_cast<FollowsChanges*>(one.get())) {
      follower->follow_changes(scene.time.end, longest);
    }
  }
  if (has_motion(scene)) {
    physics.push_back(
        std::make_unique<PrescribedMotion<Dim>>(points, std::move(motions), in_frame != nullptr));
  }
  if (std::isfinite(longest)) {
    physics.push_back(std::make_unique<PaceOfMotion>(longest));
  }
}

template void add_motion<1>(const Scene&, Points&, std::vector<std::unique_ptr<Physics>>&);
template void add_motion<2>(const Scene&, Points&, std::vector<std::unique_ptr<Physics>>&);
template void add_motion<3>(const Scene&, Points&, std::vector<std::unique_ptr<Physics>>&);

}  // namespace lapilli
