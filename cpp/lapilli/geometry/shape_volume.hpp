#pragma once

#include "lapilli/geometry/fill.hpp"

namespace lapilli {

/// Area or volume of a shape (m^dimension), summed over the boxes of a lattice, as exact as
/// `parts_of` says (box_parts.hpp). Throws std::invalid_argument as `fill` does.
double volume_of(const Shape& shape, const Lattice& lattice, const FillOptions& options,
                 int dimension);

}  // namespace lapilli
