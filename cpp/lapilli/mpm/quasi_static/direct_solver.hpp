#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "lapilli/mpm/quasi_static/node_system.hpp"

namespace lapilli {

/// What a factorisation K = L D L^T says of its matrix.
struct PivotReport {
  double smallest = 0.0;       // smallest pivot
  double largest = 0.0;        // largest pivot
  Index smallest_unknown = 0;  // where the smallest is
  Index not_positive = 0;      // pivots that are not positive; 0: the matrix is positive definite
};

/// Sparse L D L^T of a symmetric matrix given by its lower triangle, already in elimination order.
class DirectSolver {
 public:
  DirectSolver();
  ~DirectSolver();
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;

  /// Prepare for a pattern; needed again only when the pattern changes.
  void analyse(const SparseMatrix& lower);
  /// Factorise values of the analysed pattern.
  PivotReport factorise(const SparseMatrix& lower);
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const;

  /// Estimate of the condition number in the 1-norm (Higham 1988): a lower bound, mostly within 3.
  double condition(const SparseMatrix& lower) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

/// y = K x for a symmetric matrix given by its lower triangle.
Eigen::VectorXd multiply(const SparseMatrix& lower, const Eigen::VectorXd& x);

}  // namespace lapilli
