#pragma once

#include "lapilli/geometry/grid.hpp"

namespace lapilli {

/// Call body(node, offset) for the nodes of a grid within `reach` cells of `centre` along every
/// axis, first axis fastest; `offset` in cells.
template <int Dim, class Body>
void for_each_in_block(const Grid<Dim>& grid, Index centre, int reach, const Body& body) {
  const auto at = grid.node_at(centre);
  const int width = 2 * reach + 1;
  const int block = Dim == 1 ? width : Dim == 2 ? width * width : width * width * width;
  for (int b = 0; b < block; ++b) {
    auto node = at;
    Vec<Dim> offset;
    bool inside = true;
    for (int axis = 0, rest = b; axis < Dim; ++axis, rest /= width) {
      offset[axis] = rest % width - reach;
      node[axis] += rest % width - reach;
      inside = inside && node[axis] >= 0 && node[axis] < grid.nodes(axis);
    }
    if (inside) {
      body(grid.node_index(node), offset);
    }
  }
}

}  // namespace lapilli
