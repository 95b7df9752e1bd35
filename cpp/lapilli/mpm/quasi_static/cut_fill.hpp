#pragma once

#include "lapilli/geometry/fill.hpp"

namespace lapilli {

/// Fill a shape with points that integrate the gradients of the linear shape functions exactly: in
/// two dimensions one point at the centroid of each clipped lattice box (as `fill` with `clip`). In
/// three, where centroids are not exact, the boxes that the surface cuts in one cell of the grid
/// share four points with the volume, the first and the second moments of their part of the shape
/// (seven where four would lie outside of the cell); with one or two points along an axis the whole
/// cell is such a box. Exact for boxes, half-spaces and intersections of them in any position, and
/// for polygons in two dimensions; other shapes in three dimensions as `moments_of_box` says.
/// Throws std::invalid_argument as `fill` does.
FilledPoints fill_exactly(const Shape& shape, const Lattice& lattice, int dimension);

}  // namespace lapilli
