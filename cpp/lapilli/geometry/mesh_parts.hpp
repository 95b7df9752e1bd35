#pragma once

#include "lapilli/geometry/box_parts.hpp"
#include "lapilli/geometry/triangle_surface.hpp"

namespace lapilli {

/// The parts of the lattice boxes inside a closed surface that covers its inside once, exact to
/// rounding: each column of boxes adds up what lies below the triangles that face up and takes away
/// what lies below those that face down. The surface stands at turn x + shift. Time grows with the
/// pieces into which the boxes cut the triangles.
std::vector<BoxPart> mesh_parts(const TriangleSurface& surface, const Mat3& turn, const Vec3& shift,
                                const Sites& sites);

}  // namespace lapilli
