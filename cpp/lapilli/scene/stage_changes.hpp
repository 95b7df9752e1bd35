#pragma once

#include "lapilli/scene/stage_scenes.hpp"

namespace lapilli {

// What stage `k` of a scene makes of the stage before, in this order. Each throws
// std::invalid_argument with the place in the file.

/// Take bodies, obstacles and loads away by their names, with the contacts that are about them.
void remove_parts(const Scene& scene, std::size_t k, StageScene& stage);

/// Give keys other values.
void set_keys(const Scene& scene, std::size_t k, StageScene& stage);

/// Append bodies, obstacles and loads.
void add_parts(const Scene& scene, std::size_t k, StageScene& stage);

}  // namespace lapilli
