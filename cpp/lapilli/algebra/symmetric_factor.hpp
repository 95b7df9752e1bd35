#pragma once

#include <array>
#include <span>
#include <vector>

#include "lapilli/algebra/direct_solver.hpp"

namespace lapilli {

/// Factor of a symmetric matrix whose unknowns, one a node, lie on a grid: puts them in the order
/// of a nested dissection and hands them to the direct solver.
class SymmetricFactor {
 public:
  /// `matrix` with both its triangles; `place` the integer coordinates of each unknown.
  void analyse(const SparseMatrix& matrix, std::span<const std::array<int, 3>> place);
  /// Factorise values of the analysed pattern.
  PivotReport factorise(const SparseMatrix& matrix);
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;

 private:
  DirectSolver solver_;
  SparseMatrix lower_;           // in the order of elimination
  std::vector<int> order_;       // unknowns as they are eliminated
  std::vector<Index> entry_of_;  // of each number of `lower_` in the matrix
};

}  // namespace lapilli
