#pragma once

#include <functional>
#include <memory>

#include "lapilli/mpm/dynamics/overburden.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The stresses that the bodies of a scene with dynamics start with.
class StressAtStart {
 public:
  /// Throws std::invalid_argument where a body that is weighed has no shape or gravity is missing.
  explicit StressAtStart(const Scene& scene, double time = 0.0);

  /// The stress of one body by place, Pa; an empty function where it starts with none.
  std::function<SymmetricTensor(const Vec3&)> of(std::size_t body) const;

 private:
  const Scene& scene_;
  Vec3 gravity_;
  std::shared_ptr<const Overburden> overburden_;  // null where nothing is weighed
};

}  // namespace lapilli
