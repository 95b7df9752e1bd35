#pragma once

#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// Whether there is a place from which two shapes are this near together, both ways added (m); of
/// the places of a lattice of that `spacing` (m). Shapes that have no end are looked at where both
/// may be, along axes without an end in one plane.
bool come_near(const Shape& one, const Shape& other, double way, double spacing);

}  // namespace lapilli
