#pragma once

#include <array>
#include <compare>

#include "lapilli/geometry/grid.hpp"

namespace lapilli {

/// A box of neighbouring cells: the support of a material point, a wall facet or a cell face. Its
/// nodes are counted with the first axis fastest.
template <int Dim>
struct CellBox {
  std::array<int, Dim> first{};  // cell with the lowest coordinates
  std::array<int, Dim> cells{};  // along each axis

  auto operator<=>(const CellBox&) const = default;

  int node_count() const {
    int count = 1;
    for (int axis = 0; axis < Dim; ++axis) {
      count *= cells[axis] + 1;
    }
    return count;
  }

  /// Which of the box's nodes a corner of one of its cells is: bit `axis` of the corner is set on
  /// the upper side.
  int node(const std::array<int, Dim>& cell, int corner) const {
    int number = 0, stride = 1;
    for (int axis = 0; axis < Dim; ++axis) {
      number += stride * (cell[axis] - first[axis] + ((corner >> axis) & 1));
      stride *= cells[axis] + 1;
    }
    return number;
  }
};

/// Call body(k, node) for node k of the box, first axis fastest.
template <int Dim, class Body>
void for_each_node(const Grid<Dim>& grid, const CellBox<Dim>& box, const Body& body) {
  const Index corner = grid.node_index(box.first);
  int k = 0;
  if constexpr (Dim == 2) {
    for (int j = 0; j <= box.cells[1]; ++j) {
      for (int i = 0; i <= box.cells[0]; ++i) {
        body(k++, corner + i + j * grid.node_stride(1));
      }
    }
  } else {
    for (int l = 0; l <= box.cells[2]; ++l) {
      for (int j = 0; j <= box.cells[1]; ++j) {
        for (int i = 0; i <= box.cells[0]; ++i) {
          body(k++, corner + i + j * grid.node_stride(1) + l * grid.node_stride(2));
        }
      }
    }
  }
}

/// Call body(cell) for every cell of the box.
template <int Dim, class Body>
void for_each_cell(const Grid<Dim>& grid, const CellBox<Dim>& box, const Body& body) {
  const Index corner = grid.cell_index(box.first);
  const int layers = Dim == 3 ? box.cells[Dim - 1] : 1;
  for (int l = 0; l < layers; ++l) {
    for (int j = 0; j < box.cells[1]; ++j) {
      for (int i = 0; i < box.cells[0]; ++i) {
        body(corner + i + j * grid.cell_stride(1) + (Dim == 3 ? l * grid.cell_stride(Dim - 1) : 0));
      }
    }
  }
}

}  // namespace lapilli
