#pragma once

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Whether a region lies on the surface of a body as it starts, beside what rests on others; looked
/// at from place to place, a cell apart.
bool lies_on(const Scene& scene, const Shape& region, std::size_t body);

}  // namespace lapilli
