#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "lapilli/algebra/node_system.hpp"

namespace lapilli {

/// What a factorisation K = L D L^T says of its matrix.
struct PivotReport {
  double smallest = 0.0;       // smallest pivot
  double largest = 0.0;        // largest pivot
  Index smallest_unknown = 0;  // where the smallest is
  Index not_positive = 0;      // pivots that are not positive; 0: the matrix is positive definite
};

/// Sparse factorisation of a symmetric matrix given by its lower triangle, already in elimination
/// order: fronts, or CHOLMOD where the library is built with LAPILLI_CHOLMOD (which promises the
/// same bytes only for one processor and one thread of its BLAS).
class DirectSolver {
 public:
  DirectSolver();
  ~DirectSolver();
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// Prepare for a pattern; needed again only when the pattern changes. `part_start` as for
  /// `Multifrontal`.
  void analyse(const SparseMatrix& lower, std::span<const int> part_start);
  /// Factorise values of the analysed pattern.
  PivotReport factorise(const SparseMatrix& lower);
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;

  /// Estimate of the condition number in the 1-norm (Higham 1988): a lower bound, mostly within 3.
  double condition(const SparseMatrix& lower) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace lapilli
