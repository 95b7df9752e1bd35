#pragma once

#include "lapilli/geometry/fill.hpp"

namespace lapilli {

/// Fill a shape where it stands with points that integrate the gradients of the linear shape
/// functions of the grid exactly, cell by cell. In one and two dimensions one point at the centroid
/// of the part of each lattice box (as `fill` with `clip`, slivers kept). In three dimensions,
/// where a centroid is not exact, full cells hold their lattice points and cut ones four points
/// with the volume, the centroid and all second moments of their part; none leaves its cell.
/// Volumes are as exact as `parts_of` says (box_parts.hpp). Throws std::invalid_argument as `fill`
/// does.
FilledPoints fill_cells(const Shape& shape, const Lattice& lattice, const FillOptions& options,
                        int dimension);

}  // namespace lapilli
