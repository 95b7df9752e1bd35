#pragma once

#include <optional>
#include <vector>

#include "lapilli/geometry/clip.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// The corners of a shape that is a polygon in the x-y plane (box of two axes, polygon, turned or
/// moved ones), anticlockwise; nothing for other shapes.
std::optional<Outline> outline_of(const Shape& shape);

/// The cuts that together leave a convex shape with flat sides (box, half-space, intersections of
/// them, turned or moved ones), with normals of length 1; nothing for other shapes.
std::optional<std::vector<Cut<3>>> cuts_of(const Shape& shape);

}  // namespace lapilli
