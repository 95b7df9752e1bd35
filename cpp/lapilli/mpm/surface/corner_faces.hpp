#pragma once

#include <vector>

#include "lapilli/mpm/surface/nodal_surface.hpp"

namespace lapilli {

/// One face at a corner node.
template <int Dim>
struct CornerFace {
  Vec<Dim> normal;
  Vec<Dim> dual;  // one along this normal, zero along the others: dual . a_I is the face's area
};

/// The flat faces that meet around a node, at most Dim, from the area vectors of its neighbours;
/// none where they are all alike.
template <int Dim>
std::vector<CornerFace<Dim>> faces_of_corner(const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
                                             std::size_t k);

}  // namespace lapilli
