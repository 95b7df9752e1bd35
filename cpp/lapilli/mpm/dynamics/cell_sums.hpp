#pragma once

#include "lapilli/mpm/dynamics/point_kernel.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {

/// Sums of `arrays` nodal quantities over the points of one cell, kept in registers until the next
/// point lies elsewhere.
template <int Dim, class Shape, int arrays>
class CellSums {
 public:
  static constexpr int quads = Stencil<Dim, Shape>::quads;

  CellSums(const Stencil<Dim, Shape>& stencil, double* const (&to)[arrays]) : stencil_(stencil) {
    for (int k = 0; k < arrays; ++k) {
      to_[k] = to[k];
      for (int q = 0; q < quads; ++q) {
        sum[k][q] = all(0.0);
      }
    }
  }
  ~CellSums() { flush(); }

  void move_to(Index first) {
    if (first != first_) {
      flush();
      first_ = first;
    }
  }

  Double4 sum[arrays][quads];

 private:
  void flush() {
    if (first_ >= 0) {
      for (int k = 0; k < arrays; ++k) {
        for (int q = 0; q < quads; ++q) {
          stencil_.add(to_[k], first_, q, sum[k][q]);
          sum[k][q] = all(0.0);
        }
      }
    }
  }

  const Stencil<Dim, Shape>& stencil_;
  double* to_[arrays];
  Index first_ = -1;
};

/// Momentum of one point, m (v + affine), into the sums `offset` to `offset` + Dim - 1. `affine`:
/// its matrix, row-major.
template <VelocityTransfer transfer, int Dim, class Shape, int arrays>
void add_momentum(CellSums<Dim, Shape, arrays>& sums, int offset, const SimdWeights<Dim, Shape>& w,
                  const AxisWeights<Dim, Shape>& axes, double h, double mass,
                  const double* velocity, const double* affine) {
  constexpr int quads = Stencil<Dim, Shape>::quads;
  for (int axis = 0; axis < Dim; ++axis) {
    const double momentum = mass * velocity[axis];
    for (int q = 0; q < quads; ++q) {
      sums.sum[offset + axis][q] += w.value[q] * momentum;
    }
  }
  if constexpr (is_affine<transfer, Shape>) {
    double factor[Dim][Shape::support];
    affine_factors<transfer>(axes, h, factor);
    const SimdWeights<Dim, Shape> lever(axes.value, factor);
    for (int axis = 0; axis < Dim; ++axis) {
      for (int along = 0; along < Dim; ++along) {
        const double moment = mass * affine[axis * Dim + along];
        for (int q = 0; q < quads; ++q) {
          sums.sum[offset + axis][q] += lever.slope[along][q] * moment;
        }
      }
    }
  }
}

/// Nodal quantities of the cell that the points in turn lie in, loaded when the cell changes.
template <int Dim, class Shape, int arrays>
class CellNodes {
 public:
  static constexpr int quads = Stencil<Dim, Shape>::quads;

  CellNodes(const Stencil<Dim, Shape>& stencil, const double* const (&from)[arrays])
      : stencil_(stencil) {
    for (int k = 0; k < arrays; ++k) {
      from_[k] = from[k];
      for (int q = 0; q < quads; ++q) {
        node_[k][q] = all(0.0);
      }
    }
  }

  void move_to(Index first) {
    if (first != first_) {
      first_ = first;
      for (int k = 0; k < arrays; ++k) {
        for (int q = 0; q < quads; ++q) {
          node_[k][q] = stencil_.load(from_[k], first, q);
        }
      }
    }
  }

  /// Sum of one quantity with weights, its four lanes still apart.
  Double4 weigh(int array, const Double4 (&weight)[quads]) const {
    Double4 sum = node_[array][0] * weight[0];
    for (int q = 1; q < quads; ++q) {
      sum += node_[array][q] * weight[q];
    }
    return sum;
  }

 private:
  const Stencil<Dim, Shape>& stencil_;
  const double* from_[arrays];
  Index first_ = -1;
  Double4 node_[arrays][quads];
};

/// Add up the lanes of `count` quads; `to` has room for the next multiple of four.
template <int count>
void add_lanes(const Double4 (&parts)[count], double* to) {
  static_assert(count % 4 == 0);
  for (int k = 0; k < count; k += 4) {
    store_quad(to + k, sums(parts[k], parts[k + 1], parts[k + 2], parts[k + 3]));
  }
}

}  // namespace lapilli

#pragma GCC diagnostic pop
