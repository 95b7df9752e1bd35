#pragma once

#include <vector>

#include "lapilli/geometry/lattice.hpp"
#include "lapilli/geometry/moment_sum.hpp"

namespace lapilli {

/// The part of one lattice box inside a shape, in the frame of the lattice.
struct BoxPart {
  Sites::Site site;
  Part part;
};

/// First axis fastest: the order in which sites are visited.
bool visited_before(const Sites::Site& a, const Sites::Site& b);

/// The parts of all boxes that the shape meets, in the order in which sites are visited. Exact to
/// rounding for shapes with flat sides and their combinations, for images (the set pixels) in two
/// dimensions, for meshes that cover their inside once and in one dimension; otherwise as
/// `moments_inside` says (measure.hpp). Time grows with the boxes, for meshes with the triangles
/// that each box meets.
std::vector<BoxPart> parts_of(const Shape& shape, const Sites& sites);

}  // namespace lapilli
