#pragma once

#include <vector>

#include "lapilli/mpm/quasi_static/surface.hpp"
#include "lapilli/mpm/surface/plane_fit.hpp"

namespace lapilli {

/// Add points of integration on a curved surface in a cube: the cube is cut along straight lines
/// into triangles or tetrahedra, these into flat pieces, and the points moved from there to the
/// surface, whose normals they carry. `shift` (m): how far inside the material a place is looked
/// up in the cube.
template <int Dim>
void cut_simplices(const LevelSet& surface, const Cube<Dim>& cube, double shift, Trims trims,
                   std::vector<SurfacePoint<Dim>>& points);

}  // namespace lapilli
