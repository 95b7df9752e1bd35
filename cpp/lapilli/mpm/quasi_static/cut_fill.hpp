#pragma once

#include "lapilli/geometry/fill.hpp"

namespace lapilli {

/// Fill a shape with points that integrate the gradients of the linear shape functions exactly: in
/// two dimensions one point at the centroid of each clipped lattice box (as `fill` with `clip`); in
/// three, where one centroid is not exact, four points in every tetrahedron of a clipped box
/// (degree 2). Exact for boxes, half-spaces and intersections of them in any position, and for
/// polygons in two dimensions; other shapes in three dimensions are cut along their linear
/// interpolant in the six tetrahedra of each box.
/// Throws std::invalid_argument as `fill` does.
FilledPoints fill_exactly(const Shape& shape, const Lattice& lattice, int dimension);

}  // namespace lapilli
