#pragma once

#include <array>
#include <vector>

#include "lapilli/core/simd.hpp"
#include "lapilli/geometry/grid.hpp"

namespace lapilli {

/// Isotropic conduction over the cells of a plane with linear shape functions.
///
/// With values u0, u1 along one axis and v0, v1 along the other, the stiffness of a cell depends on
/// its points only through sum kV, sum kV u0^2, sum kV u1^2, sum kV v0^2 and sum kV v1^2 (u0 u1
/// follows from u0 + u1 = 1). They are summed while points are projected, which saves conduction a
/// sweep over the points of its own. Cells go by their lowest node.
class PlaneStiffness {
 public:
  explicit PlaneStiffness(const Grid<2>& grid);

  /// Forget the sums of cells [begin, end).
  void clear(Index begin, Index end);
  /// rate_I -= sum_J K_IJ T_J for the nodes of cells [begin, end); arrays by node.
  void conduct(const double* temperature, double* rate, Index begin, Index end);

  /// Sums of one cell, kept in registers while consecutive points lie in it.
  class Held {
   public:
    /// `all` may be null: then nothing is summed.
    explicit Held(PlaneStiffness* all) : all_(all) {}

    /// A point with k V = `weight` and the slopes of its patch of nodes along both axes.
    void add(Index first, double weight, Double4 slope_x, Double4 slope_y) {
      if (all_ == nullptr) {
        return;
      }
      if (first != first_) {
        flush();
        first_ = first;
      }
      across_y_ += slope_x * slope_x * weight;
      across_x_ += slope_y * slope_y * weight;
      total_ += weight;
    }
    void flush() {
      if (first_ >= 0) {
        all_->sum_[0][first_] += across_y_[0];
        all_->sum_[1][first_] += across_y_[2];
        all_->sum_[2][first_] += across_x_[0];
        all_->sum_[3][first_] += across_x_[1];
        all_->sum_[4][first_] += total_;
        across_y_ = across_x_ = Double4{};
        total_ = 0.0;
      }
    }

   private:
    Double4 across_y_{}, across_x_{};
    double total_ = 0.0;
    PlaneStiffness* all_;
    Index first_ = -1;
  };

 private:
  /// Heat along the lower and upper edge, then the left and right one, of a cell.
  enum Edge { lower, upper, left, right };

  Grid<2> grid_;
  // By cell; the first four carry 1/h^2 from the slopes.
  std::array<std::vector<double>, 5> sum_;
  std::array<std::vector<double>, 4> flow_;  // W, by edge
};

}  // namespace lapilli
