#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "lapilli/algebra/node_rows.hpp"
#include "lapilli/core/large_array.hpp"
#include "lapilli/core/parallel.hpp"

namespace lapilli {

/// A symmetric matrix that couples every node with those at most `reach` away along each axis,
/// stored as one array a neighbour: the diagonal and the neighbours that come later in the order.
template <int Dim>
class StencilMatrix {
 public:
  explicit StencilMatrix(const NodeRows<Dim>& rows);

  /// Add `value` to the entry of `node` and its neighbour `step` away, and to its mirror image
  /// (once, when the step is zero). Call for later neighbours only.
  void add(Index place, const std::array<int, Dim>& step, double value) {
    coefficient_[slot(step) * rows_->size() + place] += value;
  }
  double diagonal(Index place) const { return coefficient_[place]; }
  /// Whether a step leads to the node itself or to a later one.
  static bool is_later(const std::array<int, Dim>& step) {
    for (int axis = Dim - 1; axis > 0; --axis) {
      if (step[axis] != 0) {
        return step[axis] > 0;
      }
    }
    return step[0] >= 0;
  }

  /// (matrix x) at `lanes` consecutive places from `place`, on `row`.
  static constexpr int lanes = 8;
  using Block = std::array<double, lanes>;

  /// Call body(place, count, product) over blocks of active places: product = matrix x there.
  template <class Body>
  void multiply(const double* x, const Body& body) const;

  /// |matrix| x at the active places, zero elsewhere: the row sums that Gershgorin's circles need.
  std::vector<double> absolute_multiply(std::span<const double> x) const;

  /// The lower triangle and diagonal as a sparse matrix; `number` numbers the places (-1: left
  /// out).
  void append_triplets(std::span<const Index> number, double scale,
                       std::vector<Eigen::Triplet<double>>& triplets) const;

 private:
  struct Neighbour {
    Index rows_away;  // in grid rows
    int step;         // along the first axis
  };

  Index slot(const std::array<int, Dim>& step) const {
    Index number = 0;
    for (int axis = Dim - 1; axis >= 0; --axis) {
      number = number * width_ + step[axis] + rows_->reach();
    }
    return number - centre_;
  }
  /// Distances in places to the later neighbours of a row, and from where their mirror images are.
  void distances(const typename NodeRows<Dim>::Row& row, std::vector<Index>& later,
                 std::vector<Index>& earlier) const;

  const NodeRows<Dim>* rows_;
  int width_;
  Index centre_;
  std::vector<Neighbour> later_;    // slot 0 is the node itself
  LargeArray<double> coefficient_;  // slot-major
};

template <int Dim>
template <class Body>
void StencilMatrix<Dim>::multiply(const double* x, const Body& body) const {
  const auto& rows = rows_->rows();
  const Index size = rows_->size();
  const auto slots = static_cast<Index>(later_.size());
  // Rows are handed out in groups of about a piece, whatever the number of threads.
  const Index group =
      std::max<Index>(1, piece_rows * static_cast<Index>(rows.size()) / std::max<Index>(1, size));
  parallel_tasks((static_cast<Index>(rows.size()) + group - 1) / group, [&](Index task) {
    std::vector<Index> later, earlier;
    const Index last = std::min(static_cast<Index>(rows.size()), (task + 1) * group);
    for (Index r = task * group; r < last; ++r) {
      const auto& row = rows[r];
      distances(row, later, earlier);
      for (Index place = row.shift + row.begin; place < row.shift + row.end; place += lanes) {
        const int count = static_cast<int>(std::min<Index>(lanes, row.shift + row.end - place));
        Block product;
        if (count == lanes) {
          const double* c = coefficient_.data() + place;
          const double* at = x + place;
          for (int k = 0; k < lanes; ++k) {
            product[k] = c[k] * at[k];
          }
          for (Index s = 1; s < slots; ++s) {
            const double* up = c + s * size;
            const double* down = up + earlier[s];
            const double* x_up = at + later[s];
            const double* x_down = at + earlier[s];
            for (int k = 0; k < lanes; ++k) {
              product[k] += up[k] * x_up[k] + down[k] * x_down[k];
            }
          }
        } else {
          for (int k = 0; k < count; ++k) {
            const double* c = coefficient_.data() + place + k;
            const double* at = x + place + k;
            product[k] = c[0] * at[0];
            for (Index s = 1; s < slots; ++s) {
              const double* up = c + s * size;
              product[k] += up[0] * at[later[s]] + up[earlier[s]] * at[earlier[s]];
            }
          }
        }
        body(place, count, product);
      }
    }
  });
}

}  // namespace lapilli
