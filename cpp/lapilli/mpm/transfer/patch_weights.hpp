#pragma once

#include <algorithm>
#include <array>
#include <type_traits>

#include "lapilli/core/simd.hpp"
#include "lapilli/core/vector.hpp"
#include "lapilli/geometry/grid.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {

/// The shape function of a point by its body, where all bodies share one.
template <class Shape>
struct OneShape {
  Shape shape;
  const Shape& operator()(Index) const { return shape; }
};

/// Shape function values of four consecutive points, evaluated together and handed out point by
/// point as patches of nodes: what the transfer loops work on. A patch is a Double4: a row of nodes
/// along the first axis (the last lanes zero where two or three are in reach), or the 2 x 2 nodes
/// of the first two axes for linear functions. Gradients are per metre.
template <int Dim, class Shape>
class PatchWeights {
 public:
  static constexpr int points = 4;
  static constexpr int dimension = Dim;
  static constexpr int support = Shape::support;
  /// Axes that lie in a patch; the others lie across.
  static constexpr int inner = support == 2 && Dim > 1 ? 2 : 1;
  static constexpr int outer = Dim - inner;
  static constexpr int patches = outer == 0 ? 1 : outer == 1 ? support : support * support;

  /// `position` holds `count` (1 to 4) points, Dim numbers each; `shape_of(body[k])` is the shape
  /// function of the k-th.
  template <class ShapeOf>
  PatchWeights(const Grid<Dim>& grid, const double* position, int count, const ShapeOf& shape_of,
               const Index* body) {
    const double h = grid.cell_size(), inverse_h = grid.inverse_cell_size();
    const Shape shape = shape_of(body[0]);
    bool same = true;
    if constexpr (!std::is_same_v<ShapeOf, OneShape<Shape>>) {
      for (int k = 1; k < count; ++k) {
        same = same && shape_of(body[k]).half_width == shape.half_width;
      }
    }
    Double4 first_value[support], first_slope[support];
#pragma GCC unroll 3
    for (int axis = 0; axis < Dim; ++axis) {
      const double* x = position + axis;
      const int last = count - 1;
      const Double4 place{x[0], x[std::min(1, last) * Dim], x[std::min(2, last) * Dim],
                          x[std::min(3, last) * Dim]};
      const Double4 at = (place - grid.origin()[axis]) * inverse_h;
      const auto base = __builtin_convertvector(at - Shape::base_shift, Four);
      const Double4 lowest = __builtin_convertvector(base, Double4);
      Double4 value[support], slope[support];
      if (same) {
        shape.evaluate(at, lowest, value, slope);
      } else {
        evaluate_each(shape_of, body, count, at, lowest, value, slope);
      }
#pragma GCC unroll 3
      for (Double4& quad : slope) {
        quad *= inverse_h;
      }
      const int stride = static_cast<int>(grid.node_stride(axis));
      first_ = axis == 0 ? base : first_ + base * stride;
      store_quad(from_base_[axis], (at - lowest) * h);
      if (axis == 0) {
        std::copy(value, value + support, first_value);
        std::copy(slope, slope + support, first_slope);
        if constexpr (inner == 1) {
          const Double4 none{};
          turn(value[0], value[1], support > 2 ? value[support - 1] : none, none, value_);
          turn(slope[0], slope[1], support > 2 ? slope[support - 1] : none, none, slope_[0]);
        }
      } else if (axis < inner) {
        const Double4 *v = first_value, *s = first_slope;
        turn(v[0] * value[0], v[1] * value[0], v[0] * value[1], v[1] * value[1], value_);
        turn(s[0] * value[0], s[1] * value[0], s[0] * value[1], s[1] * value[1], slope_[0]);
        turn(v[0] * slope[0], v[1] * slope[0], v[0] * slope[1], v[1] * slope[1], slope_[inner - 1]);
      } else {
#pragma GCC unroll 3
        for (int k = 0; k < support; ++k) {
          store_quad(across_[axis - inner][k], value[k]);
          store_quad(across_slope_[axis - inner][k], slope[k]);
        }
      }
    }
  }

  /// The view of one of the points.
  class Point {
   public:
    Point(const PatchWeights& all, int point) : all_(all), point_(point) {}

    Index first() const { return all_.first_[point_]; }  // lowest node in reach
    /// Values over a patch and, along an axis in it, slopes: to be multiplied by `across`.
    Double4 value() const { return all_.value_[point_]; }
    Double4 slope(int axis) const { return all_.slope_[axis][point_]; }
    /// Distance from the lowest node, m.
    double from_base(int axis) const { return all_.from_base_[axis][point_]; }

    /// Product of the values of the axes across patch number `patch`.
    double across(int patch) const {
      if constexpr (outer == 0) {
        return 1.0;
      } else if constexpr (outer == 1) {
        return all_.across_[0][patch][point_];
      } else {
        return all_.across_[0][patch % support][point_] * all_.across_[1][patch / support][point_];
      }
    }
    /// The same with the slope along `axis`, one across the patch, in place of its value.
    double slope_across(int patch, int axis) const {
      if constexpr (outer == 0) {
        return 0.0;
      } else if constexpr (outer == 1) {
        return all_.across_slope_[0][patch][point_];
      } else {
        const int j = patch % support, k = patch / support;
        return axis == inner ? all_.across_slope_[0][j][point_] * all_.across_[1][k][point_]
                             : all_.across_[0][j][point_] * all_.across_slope_[1][k][point_];
      }
    }

   private:
    const PatchWeights& all_;
    int point_;
  };

  Point operator[](int point) const { return Point(*this, point); }

 private:
  using Four = int __attribute__((vector_size(16)));

  template <class ShapeOf>
  static void evaluate_each(const ShapeOf& shape_of, const Index* body, int count, Double4 at,
                            Double4 lowest, Double4* value, Double4* slope) {
    for (int k = 0; k < points; ++k) {
      double v[support], s[support];
      shape_of(body[std::min(k, count - 1)]).evaluate(at[k], lowest[k], v, s);
      for (int i = 0; i < support; ++i) {
        value[i][k] = v[i];
        slope[i][k] = s[i];
      }
    }
  }

  /// From one quad a node, lanes the points, to one quad a point, lanes the nodes.
  static void turn(Double4 a, Double4 b, Double4 c, Double4 d, Double4* by_point) {
    const Double4 ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const Double4 ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Double4 cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Double4 cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    by_point[0] = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
    by_point[1] = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
    by_point[2] = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
    by_point[3] = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
  }

  Four first_;
  Double4 value_[points], slope_[inner][points];
  double from_base_[Dim][points];
  double across_[outer > 0 ? outer : 1][support][points];
  double across_slope_[outer > 0 ? outer : 1][support][points];
};

/// Where the patches of nodal arrays are: reads them, adds to them, knows where their nodes lie.
template <int Dim, class Shape>
class PatchNodes {
 public:
  using Weights = PatchWeights<Dim, Shape>;

  explicit PatchNodes(const Grid<Dim>& grid) : h_(grid.cell_size()) {
    for (int axis = 1; axis < Dim; ++axis) {
      stride_[axis] = grid.node_stride(axis);
    }
    lanes_[0] =
        Weights::inner == 2 ? Double4{0.0, h_, 0.0, h_} : Double4{0.0, h_, 2.0 * h_, 3.0 * h_};
    lanes_[1] = Double4{0.0, 0.0, h_, h_};
  }

  Double4 read(const double* nodes, Index first, int patch) const {
    const double* at = nodes + first + offset(patch);
    if constexpr (Weights::inner == 2) {
      const double* next = at + stride_[1];
      return Double4{at[0], at[1], next[0], next[1]};
    } else {
      return load_quad(at);
    }
  }
  void add(double* nodes, Index first, int patch, Double4 values) const {
    double* at = nodes + first + offset(patch);
    if constexpr (Weights::inner == 2) {
      double* next = at + stride_[1];
      at[0] += values[0];
      at[1] += values[1];
      next[0] += values[2];
      next[1] += values[3];
    } else {
      store_quad(at, load_quad(at) + values);
    }
  }
  /// Distances of a patch's nodes from the lowest one along an axis in it, m.
  Double4 lanes(int axis) const { return lanes_[axis]; }
  /// Distance of a patch from the lowest node along an axis across it, m.
  double distance(int patch, int axis) const {
    return h_ * (axis == Weights::inner ? patch % Weights::support : patch / Weights::support);
  }

 private:
  Index offset(int patch) const {
    if constexpr (Weights::outer == 0) {
      return 0;
    } else if constexpr (Weights::outer == 1) {
      return patch * stride_[Dim - 1];
    } else {
      return (patch % Weights::support) * stride_[1] + (patch / Weights::support) * stride_[2];
    }
  }

  double h_;
  Index stride_[3] = {1, 0, 0};
  Double4 lanes_[2];
};

/// Patches of `Arrays` nodal arrays summed in registers while consecutive points share their nodes.
template <int Dim, class Shape, int Arrays>
class HeldPatches {
 public:
  static constexpr int patches = PatchWeights<Dim, Shape>::patches;

  HeldPatches(const PatchNodes<Dim, Shape>& nodes, const std::array<double*, Arrays>& arrays)
      : nodes_(nodes), arrays_(arrays) {}

  void hold(Index first) {
    if (first != first_) {
      flush();
      first_ = first;
    }
  }
  void flush() {
    if (first_ < 0) {
      return;
    }
#pragma GCC unroll 5
    for (int array = 0; array < Arrays; ++array) {
#pragma GCC unroll 9
      for (int patch = 0; patch < patches; ++patch) {
        nodes_.add(arrays_[array], first_, patch, sum[array][patch]);
        sum[array][patch] = Double4{};
      }
    }
  }

  Double4 sum[Arrays][patches] = {};

 private:
  PatchNodes<Dim, Shape> nodes_;
  std::array<double*, Arrays> arrays_;
  Index first_ = -1;
};

/// Call body(row, weights) for the points [begin, end), whose weights are evaluated four at a time.
template <int Dim, class ShapeOf, class Body>
void for_points(const Grid<Dim>& grid, Index begin, Index end, const double* position,
                const ShapeOf& shape_of, const Index* body_of, const Body& body) {
  using Weights = PatchWeights<Dim, std::decay_t<decltype(shape_of(0))>>;
  for (Index row = begin; row < end; row += Weights::points) {
    const int count = static_cast<int>(std::min<Index>(Weights::points, end - row));
    const Weights weights(grid, position + row * Dim, count, shape_of, body_of + row);
    for (int k = 0; k < count; ++k) {
      body(row + k, weights[k]);
    }
  }
}

}  // namespace lapilli
