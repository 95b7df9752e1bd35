#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/mpm/dynamics/overburden.hpp"
#include "lapilli/scene/bearable_k0.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The stresses that the bodies of a scene with dynamics start with.
class StressAtStart {
 public:
  /// Throws std::invalid_argument where a body that is weighed has no shape or gravity is missing.
  explicit StressAtStart(const Scene& scene, double time = 0.0);

  /// The stress of one body by place, Pa; an empty function where it starts with none.
  /// Where the strength of the body does not bear its k0, the nearest that it bears.
  std::function<SymmetricTensor(const Vec3&)> of(std::size_t body) const;
  /// On the bodies whose k0 was not borne at the places asked for so far.
  std::vector<Note> notes() const;

 private:
  /// The place of a body that was farthest from its k0.
  struct Worst {
    Index asked = 0, not_borne = 0;  // places
    double away = -1.0;
    Vec3 place = Vec3::Zero();
    std::optional<BearableK0::Range> borne;
  };
  BearableK0::Stress by_k0(std::size_t body, const Vec3& at) const;

  const Scene& scene_;
  Vec3 gravity_;
  std::shared_ptr<const Overburden> overburden_;  // null where nothing is weighed
  mutable std::map<std::size_t, Worst> worst_;    // by body with a stress at the start
};

}  // namespace lapilli
