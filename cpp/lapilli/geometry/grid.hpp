#pragma once

#include <array>
#include <cmath>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Uniform background grid over [lower, upper], with `padding` more cells on every side so that no
/// shape function meets an end and the outside of a body is always connected.
/// Nodes and cells are counted with the first axis fastest.
template <int Dim>
class Grid {
 public:
  using Cell = std::array<int, Dim>;
  static constexpr int padding = 3;

  /// Throws std::invalid_argument unless upper - lower is a positive whole number of cells (to 1e-6
  /// of a cell) and the node count fits 31 bits.
  Grid(const Vec<Dim>& lower, const Vec<Dim>& upper, double cell_size);

  double cell_size() const { return h_; }
  double inverse_cell_size() const { return inverse_h_; }
  double cell_volume() const { return std::pow(h_, Dim); }
  const Vec<Dim>& lower() const { return lower_; }
  const Vec<Dim>& upper() const { return upper_; }
  /// Position of node 0, `padding` cells below `lower`.
  const Vec<Dim>& origin() const { return origin_; }

  int cells(int axis) const { return cells_[axis]; }      // along one axis, padding included
  int nodes(int axis) const { return cells_[axis] + 1; }  //
  Index node_count() const { return node_count_; }
  Index cell_count() const { return cell_count_; }
  /// Distance in the node numbering between neighbours along `axis`.
  Index node_stride(int axis) const { return node_stride_[axis]; }
  Index cell_stride(int axis) const { return cell_stride_[axis]; }

  Index node_index(const Cell& node) const { return dot(node, node_stride_); }
  Index cell_index(const Cell& cell) const { return dot(cell, cell_stride_); }
  Cell node_at(Index index) const { return split(index, 1); }
  Cell cell_at(Index index) const { return split(index, 0); }
  Vec<Dim> node_position(Index index) const;

  /// Position in units of cells from node 0.
  Vec<Dim> local(const Vec<Dim>& position) const { return (position - origin_) * inverse_h_; }
  Cell cell_containing(const Vec<Dim>& position) const;
  /// Whether `position` lies in [lower, upper], a rounding error allowed; false for NaN.
  bool contains(const Vec<Dim>& position) const;

 private:
  static Index dot(const Cell& at, const std::array<Index, Dim>& stride) {
    Index sum = at[0];
    for (int axis = 1; axis < Dim; ++axis) {
      sum += at[axis] * stride[axis];
    }
    return sum;
  }
  Cell split(Index index, int extra) const {
    Cell at;
    for (int axis = 0; axis < Dim - 1; ++axis) {
      const Index count = cells_[axis] + extra;
      at[axis] = static_cast<int>(index % count);
      index /= count;
    }
    at[Dim - 1] = static_cast<int>(index);
    return at;
  }

  Vec<Dim> lower_, upper_, origin_;
  double h_, inverse_h_;
  Cell cells_;
  std::array<Index, Dim> node_stride_, cell_stride_;
  Index node_count_, cell_count_;
};

}  // namespace lapilli
