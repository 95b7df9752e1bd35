#pragma once

#include <optional>
#include <vector>

#include "lapilli/core/simulation.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/scene/initial_state.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// What the physics of a stage are made from beside its scene.
struct Beginning {
  std::vector<FilledPoints> filled;
  std::optional<InitialState> initial;      // none where all bodies start anew
  std::shared_ptr<const PointStart> start;  // null: all start anew, in a run of one stage
  double time = 0.0;                        // s

  bool goes_on(std::size_t body) const { return initial && initial->continues(body); }
};

/// Points and physics of a scene.
Simulation::Stage::Parts parts_of(const Scene& scene, const Beginning& beginning);

}  // namespace lapilli
