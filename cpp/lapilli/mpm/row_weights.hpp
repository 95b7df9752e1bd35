#pragma once

#include "lapilli/core/quad.hpp"
#include "lapilli/core/vector.hpp"
#include "lapilli/mpm/grid.hpp"
#include "lapilli/mpm/shape_function.hpp"

namespace lapilli {

/// Shape function values of a point as rows of nodes along the first axis: what the transfer loops
/// work on: a Quad is four neighbouring nodes of a row, the last lanes zero where two or three are
/// in reach. Gradients are per metre.
template <int Dim, class Shape>
struct RowWeights {
  static constexpr int support = Shape::support;
  static constexpr int rows = Dim == 1 ? 1 : Dim == 2 ? support : support * support;

  RowWeights(const Grid<Dim>& grid, const Shape& shape, const double* position) {
    const double inverse_h = grid.inverse_cell_size();
    first = 0;
    for (int axis = 0; axis < Dim; ++axis) {
      const double at = (position[axis] - grid.origin()[axis]) * inverse_h;
      const int base = Shape::base(at);
      double s[support], g[support];
      shape.evaluate(at, base, s, g);
      first += base * grid.node_stride(axis);
      from_base[axis] = (at - base) * grid.cell_size();
      for (int k = 0; k < support; ++k) {
        if (axis == 0) {
          along[k] = s[k];
          along_slope[k] = g[k] * inverse_h;
        } else {
          across[axis - 1][k] = s[k];
          across_slope[axis - 1][k] = g[k] * inverse_h;
        }
      }
    }
  }

  /// Call body(row, offset in nodes, product of the other axes' values) for every row of nodes.
  template <class Body>
  void for_each_row(const Grid<Dim>& grid, const Body& body) const {
    if constexpr (Dim == 1) {
      body(0, Index{0}, 1.0);
    } else if constexpr (Dim == 2) {
      for (int j = 0; j < support; ++j) {
        body(j, j * grid.node_stride(1), across[0][j]);
      }
    } else {
      for (int k = 0; k < support; ++k) {
        for (int j = 0; j < support; ++j) {
          body(k * support + j, j * grid.node_stride(1) + k * grid.node_stride(2),
               across[0][j] * across[1][k]);
        }
      }
    }
  }

  /// Slope across the row, along axis 1 or 2, of the product of the other axes' values.
  double slope_across(int row, int axis) const {
    if constexpr (Dim == 2) {
      return across_slope[0][row];
    } else if constexpr (Dim == 3) {
      const int j = row % support, k = row / support;
      return axis == 1 ? across_slope[0][j] * across[1][k] : across[0][j] * across_slope[1][k];
    } else {
      return 0.0;
    }
  }

  Index first;                  // lowest node in reach
  double from_base[Dim];        // m, position minus that of the lowest node
  Quad along{}, along_slope{};  // along the first axis
  double across[Dim > 1 ? Dim - 1 : 1][support];
  double across_slope[Dim > 1 ? Dim - 1 : 1][support];
};

}  // namespace lapilli
