#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "lapilli/algebra/node_system.hpp"

namespace lapilli {

/// Sparse L D L^T without pivoting by fronts (Duff & Reid 1983): unknowns are eliminated part by
/// part, each part as a dense matrix of its own unknowns and those it is coupled to. Parts that do
/// not depend on each other are worked on by several threads, with the same bytes for any number.
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
