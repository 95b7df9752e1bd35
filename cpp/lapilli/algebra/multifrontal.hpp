#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "lapilli/algebra/node_system.hpp"

namespace lapilli {

/// Sparse L D L^T without pivoting by fronts (Duff & Reid 1983): unknowns are eliminated part by
/// part, each part as a dense matrix of its own unknowns and those it is coupled to. Parts that do
/// not depend on each other are worked on by several threads, with the same bytes for any number.
///
/// Kept beside libraries because, measured (bench/direct_solvers, one core, processor seconds of a
/// factorisation; unknowns in the plane | in space):
///                          5,202   20,402   80,802 |  3,993
///   these fronts           0.009    0.045     0.26 |  0.061
///   CHOLMOD, OpenBLAS      0.023    0.106     0.55 |  0.044
///   UMFPACK, OpenBLAS      0.038    0.210     1.15 |  0.177
///   Eigen LDLT, AMD        0.020    0.252     3.14 |  0.881
///   Eigen LDLT, this order 0.021    0.162     1.44 |  0.202
///   Eigen SparseLU         0.073    0.692     3.80 |  0.398
/// and because factors do not depend on the threads of a BLAS. CHOLMOD is a choice of the build.
class Multifrontal {
 public:
  /// Prepare for a pattern in elimination order. `part_start` cuts the unknowns into parts that are
  /// eliminated together: part k is [part_start[k], part_start[k + 1]).
  void analyse(const SparseMatrix& lower, std::span<const int> part_start);
  void factorise(const SparseMatrix& lower);
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;

  const Eigen::VectorXd& pivots() const { return pivots_; }
  /// Numbers held by the factors.
  Index entries() const;

 private:
  struct Front {
    int begin = 0, own = 0;     // unknowns eliminated here
    std::vector<int> border;    // unknowns coupled to them that come later, sorted
    std::vector<int> children;  // fronts whose borders end here
    Eigen::MatrixXd panel;      // (own + border) x own: factors of the own columns
  };

  void build(const SparseMatrix& lower, Front& front, Eigen::MatrixXd& matrix) const;
  void eliminate(Front& front, Eigen::MatrixXd& matrix);

  std::vector<Front> fronts_;
  std::vector<std::vector<int>> levels_;  // fronts by height above the leaves
  std::vector<Eigen::MatrixXd> update_;   // what a front leaves to its parent
  Eigen::VectorXd pivots_;
};

}  // namespace lapilli
