#pragma once

#include "lapilli/geometry/box_parts.hpp"
#include "lapilli/geometry/fill.hpp"

namespace lapilli {

/// Boxes filled less than `least` (m^dimension) join the fullest of their neighbours: volume and
/// first moment are kept. Those without a neighbour are left out and the other volumes scaled to
/// the same sum.
void merge_slivers(std::vector<BoxPart>& boxes, double least);

/// Area or volume (m^dimension) of all parts.
double volume_of(const std::vector<BoxPart>& boxes);

}  // namespace lapilli
