#pragma once

#include "lapilli/geometry/triangle_surface.hpp"

namespace lapilli {

/// Triangles that share vertices, made of triangles that each bring their own corners: corners
/// nearer to each other than `tolerance` (m) become one vertex, the first that came. Programs write
/// the corners of neighbours with different rounding.
Triangles welded(const std::vector<std::array<Vec3, 3>>& triangles, double tolerance);

}  // namespace lapilli
