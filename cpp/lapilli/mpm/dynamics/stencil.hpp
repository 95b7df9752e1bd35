#pragma once

#include <algorithm>

#include "lapilli/core/simd.hpp"
#include "lapilli/geometry/grid.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {

/// One-dimensional shape functions of a point along every axis, and the node its stencil starts at.
template <int Dim, class Shape>
struct AxisWeights {
  static constexpr int support = Shape::support;

  /// `offset`: of the first node of this grid in the nodal arrays.
  AxisWeights(const Grid<Dim>& grid, const Shape& shape, const double* position, Index offset = 0) {
    const double scale = grid.inverse_cell_size();
    first = offset;
    for (int axis = 0; axis < Dim; ++axis) {
      at[axis] = (position[axis] - grid.origin()[axis]) * scale;
      base[axis] = Shape::base(at[axis]);
      if constexpr (support == 2) {
        // On a face one node of the cell has no mass but all of the slope: keep a trace of it.
        constexpr double trace = 1e-10;
        at[axis] = std::clamp(at[axis], base[axis] + trace, base[axis] + (1.0 - trace));
      }
      shape.evaluate(at[axis], base[axis], value[axis], slope[axis]);
      for (int k = 0; k < support; ++k) {
        slope[axis][k] *= scale;
      }
      first += base[axis] * grid.node_stride(axis);
    }
  }

  Index first;
  int base[Dim];
  double at[Dim];  // position in cells
  double value[Dim][support], slope[Dim][support];
};

/// The nodes in reach of a point, four at a time: with linear functions a quad is a 2 x 2 square of
/// nodes, otherwise a row of three along the first axis and one more whose weight is zero.
template <int Dim, class Shape>
struct Stencil {
  static constexpr bool square = Shape::support == 2;
  static constexpr int quads = square ? (Dim == 2 ? 1 : 2) : (Dim == 2 ? 3 : 9);

  explicit Stencil(const Grid<Dim>& grid) {
    row = grid.node_stride(1);
    if constexpr (square) {
      for (int q = 0; q < quads; ++q) {
        offset[q] = q * grid.node_stride(Dim - 1);
      }
    } else {
      for (int q = 0; q < quads; ++q) {
        offset[q] = (q % 3) * row + (q / 3) * grid.node_stride(Dim - 1);
      }
    }
  }

  Double4 load(const double* nodes, Index first, int q) const {
    const double* from = nodes + first + offset[q];
    if constexpr (square) {
      return Double4{from[0], from[1], from[row], from[row + 1]};
    } else {
      return load_quad(from);
    }
  }

  void add(double* nodes, Index first, int q, Double4 values) const {
    double* to = nodes + first + offset[q];
    if constexpr (square) {
      to[0] += values[0];
      to[1] += values[1];
      to[row] += values[2];
      to[row + 1] += values[3];
    } else {
      store_quad(to, load_quad(to) + values);
    }
  }

  Index row;
  Index offset[quads];
};

/// Products of one-dimensional factors over a stencil: values, and one derivative (or lever) an
/// axis.
template <int Dim, class Shape>
struct SimdWeights {
  static constexpr int support = Shape::support;
  static constexpr int quads = Stencil<Dim, Shape>::quads;

  SimdWeights(const double (&v)[Dim][support], const double (&s)[Dim][support]) {
    if constexpr (support == 2) {
      const Double4 x{v[0][0], v[0][1], v[0][0], v[0][1]}, y{v[1][0], v[1][0], v[1][1], v[1][1]};
      const Double4 dx{s[0][0], s[0][1], s[0][0], s[0][1]}, dy{s[1][0], s[1][0], s[1][1], s[1][1]};
      const Double4 xy = x * y, dxy = dx * y, xdy = x * dy;
      if constexpr (Dim == 2) {
        value[0] = xy;
        slope[0][0] = dxy;
        slope[1][0] = xdy;
      } else {
        for (int q = 0; q < 2; ++q) {
          value[q] = xy * v[2][q];
          slope[0][q] = dxy * v[2][q];
          slope[1][q] = xdy * v[2][q];
          slope[2][q] = xy * s[2][q];
        }
      }
    } else {
      const Double4 x{v[0][0], v[0][1], v[0][2], 0.0}, dx{s[0][0], s[0][1], s[0][2], 0.0};
      for (int q = 0; q < quads; ++q) {
        const int j = q % 3;
        if constexpr (Dim == 2) {
          value[q] = x * v[1][j];
          slope[0][q] = dx * v[1][j];
          slope[1][q] = x * s[1][j];
        } else {
          const int k = q / 3;
          const double yz = v[1][j] * v[2][k];
          value[q] = x * yz;
          slope[0][q] = dx * yz;
          slope[1][q] = x * (s[1][j] * v[2][k]);
          slope[2][q] = x * (v[1][j] * s[2][k]);
        }
      }
    }
  }

  Double4 value[quads];
  Double4 slope[Dim][quads];
};

}  // namespace lapilli

#pragma GCC diagnostic pop
