#pragma once

#include "lapilli/geometry/fill.hpp"
#include "lapilli/geometry/lattice.hpp"

namespace lapilli {

/// Append the part of each lattice box inside the shape: volume and centroid. Boxes filled less
/// than `smallest` join the fullest of their neighbours (volume and first moment are kept); those
/// without a neighbour are left out and the other volumes scaled to the same sum.
void fill_clipped(const Shape& shape, const Sites& sites, double smallest, FilledPoints& points);

/// Area or volume of the shape (m^dimension), by the same rules.
double clipped_volume(const Shape& shape, const Sites& sites);

}  // namespace lapilli
