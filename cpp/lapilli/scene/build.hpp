#pragma once

#include <memory>

#include "lapilli/core/simulation.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The simulation of a scene: bodies filled with points and every physics that the scene has a
/// section for. Throws std::invalid_argument, with the place in the scene file where there is one,
/// for everything a user may get wrong.
std::unique_ptr<Simulation> build(const Scene& scene);

}  // namespace lapilli
