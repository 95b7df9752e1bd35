#pragma once

#include "lapilli/core/vector.hpp"
#include "lapilli/geometry/grid.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {

/// Shape function values and gradients of one material point, as products of one-dimensional ones.
template <int Dim, class Shape>
struct Weights {
  static constexpr int support = Shape::support;
  static constexpr int nodes = Dim == 1   ? support
                               : Dim == 2 ? support * support
                                          : support * support * support;

  /// `position` must lie inside the grid.
  Weights(const Grid<Dim>& grid, const Shape& shape, const double* position) {
    first = 0;
    for (int axis = 0; axis < Dim; ++axis) {
      const double at = (position[axis] - grid.origin()[axis]) * grid.inverse_cell_size();
      base[axis] = Shape::base(at);
      shape.evaluate(at, base[axis], value[axis], slope[axis]);
      for (int k = 0; k < support; ++k) {
        slope[axis][k] *= grid.inverse_cell_size();
      }
      first += base[axis] * grid.node_stride(axis);
    }
  }

  /// Call body(node, S, grad S) for every node in reach, first axis fastest.
  template <class Body>
  void for_each_node(const Grid<Dim>& grid, const Body& body) const {
    if constexpr (Dim == 1) {
      for (int i = 0; i < support; ++i) {
        body(first + i, value[0][i], Vec<1>(slope[0][i]));
      }
    } else if constexpr (Dim == 2) {
      for (int j = 0; j < support; ++j) {
        const Index row = first + j * grid.node_stride(1);
        for (int i = 0; i < support; ++i) {
          body(row + i, value[0][i] * value[1][j],
               Vec<2>(slope[0][i] * value[1][j], value[0][i] * slope[1][j]));
        }
      }
    } else {
      for (int k = 0; k < support; ++k) {
        for (int j = 0; j < support; ++j) {
          const Index row = first + j * grid.node_stride(1) + k * grid.node_stride(2);
          const double yz = value[1][j] * value[2][k];
          const double ydz = value[1][j] * slope[2][k], dyz = slope[1][j] * value[2][k];
          for (int i = 0; i < support; ++i) {
            body(row + i, value[0][i] * yz,
                 Vec<3>(slope[0][i] * yz, value[0][i] * dyz, value[0][i] * ydz));
          }
        }
      }
    }
  }

  Index first;  // lowest node in reach
  int base[Dim];
  double value[Dim][support], slope[Dim][support];  // 1, 1/m
};

/// The shape function of a point of half-width `half_width` cells: one call of body(shape) with the
/// type that the scene chose. The only place where the choice becomes a type.
template <class Body>
decltype(auto) with_shape(ShapeFunction choice, double half_width, const Body& body) {
  switch (choice) {
    case ShapeFunction::linear:
      return body(LinearShape{});
    case ShapeFunction::bspline:
      return body(GimpShape{0.5});
    case ShapeFunction::gimp:
      break;
  }
  return body(GimpShape{half_width});
}

/// Nodes an axis that a point of this shape function touches.
constexpr int support_of(ShapeFunction choice) { return choice == ShapeFunction::linear ? 2 : 3; }

}  // namespace lapilli
