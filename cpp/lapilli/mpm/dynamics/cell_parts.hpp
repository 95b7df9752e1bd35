#pragma once

#include <algorithm>

#include "lapilli/mpm/dynamics/cell_sums.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {

/// The parts of the domain of a point in the cells that it may overlap, two an axis: share of the
/// domain, and share times the middle of the part, in cells from the lowest corner of the cell.
/// Under linear functions a point is all in its own cell.
template <int Dim, class Shape>
struct CellParts {
  /// Of a point at `position`; `offset` of the first node of the grid in the nodal arrays.
  CellParts(const Grid<Dim>& grid, const Shape& shape, const double* position, Index offset) {
    first = offset;
    for (int axis = 0; axis < Dim; ++axis) {
      const double at = (position[axis] - grid.origin()[axis]) * grid.inverse_cell_size();
      const int base = Shape::base(at);
      first += base * grid.node_stride(axis);
      cut(shape, axis, at, base);
    }
  }
  /// Of the point that the weights belong to.
  CellParts(const AxisWeights<Dim, Shape>& axes, const Shape& shape) : first(axes.first) {
    for (int axis = 0; axis < Dim; ++axis) {
      cut(shape, axis, axes.at[axis], axes.base[axis]);
    }
  }

  Index first;  // cell
  double share[Dim][2], moment[Dim][2];

 private:
  void cut(const Shape& shape, int axis, double at, int base) {
    if constexpr (Shape::support == 2) {
      share[axis][0] = 1.0;
      share[axis][1] = moment[axis][1] = 0.0;
      moment[axis][0] = at - base;
    } else {
      const double l = shape.half_width, face = at - (base + 1.0);
      const double inside = std::clamp(face, -l, l);
      const double below = 0.5 * (l - inside), above = 0.5 * (l + inside);  // half their widths
      const double scale = 2.0 * shape.scale;
      share[axis][0] = below * scale;
      share[axis][1] = above * scale;
      moment[axis][0] = share[axis][0] * (1.0 + face - above);
      moment[axis][1] = share[axis][1] * (face + below);
    }
  }
};

/// Gives a point the dilatation of its cells.
template <int Dim, class Shape>
class PointDilatation {
 public:
  PointDilatation(const DynamicsData<Dim>& data, const NodeField<Dim>& field)
      : cells_(data.dilatation.get()),
        shape_of_(data.half_widths),
        stencil_(field.grid),
        rates_(stencil_, {cells_ ? cells_->rate() : nullptr}) {}

  bool counts(Index body) const { return cells_ && cells_->of_body(body); }

  /// The trace of the velocity gradient of a point becomes the mean.
  [[gnu::noinline]] void operator()(Index body, const AxisWeights<Dim, Shape>& axes,
                                    double* gradient) {
    const CellParts<Dim, Shape> parts(axes, shape_of_(body));
    const SimdWeights<Dim, LinearShape> w(parts.share, parts.moment);
    rates_.move_to(parts.first);
    const Double4 rate = rates_.weigh(0, w.value);
    double change = (rate[0] + rate[1]) + (rate[2] + rate[3]);
    for (int axis = 0; axis < Dim; ++axis) {
      change -= gradient[axis * Dim + axis];
    }
    for (int axis = 0; axis < Dim; ++axis) {
      gradient[axis * Dim + axis] += change / Dim;
    }
  }

 private:
  const CellDilatation<Dim>* cells_;
  ShapeOfBody<Shape> shape_of_;
  Stencil<Dim, LinearShape> stencil_;
  CellNodes<Dim, LinearShape, 1> rates_;
};

}  // namespace lapilli

#pragma GCC diagnostic pop
