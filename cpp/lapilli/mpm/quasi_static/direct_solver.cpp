#include "lapilli/mpm/quasi_static/direct_solver.hpp"

#include <Eigen/SparseCholesky>
#include <limits>

namespace lapilli {

struct DirectSolver::Factor {
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt;
};

DirectSolver::DirectSolver() : factor_(std::make_unique<Factor>()) {}
DirectSolver::~DirectSolver() = default;

void DirectSolver::analyse(const SparseMatrix& lower) { factor_->ldlt.analyzePattern(lower); }

PivotReport DirectSolver::factorise(const SparseMatrix& lower) {
  factor_->ldlt.factorize(lower);
  PivotReport report;
  report.smallest = std::numeric_limits<double>::infinity();
  const auto& pivots = factor_->ldlt.vectorD();
  for (Index k = 0; k < pivots.size(); ++k) {
    if (!(pivots[k] > 0.0)) {
      ++report.not_positive;
    }
    if (!(pivots[k] >= report.smallest)) {
      report.smallest = pivots[k];
      report.smallest_unknown = k;
    }
    report.largest = std::max(report.largest, pivots[k]);
  }
  return report;
}

Eigen::VectorXd DirectSolver::solve(const Eigen::VectorXd& right_side) const {
  return factor_->ldlt.solve(right_side);
}

double DirectSolver::condition(const SparseMatrix& lower) const {
  const Index count = lower.rows();
  Eigen::VectorXd column_sum = Eigen::VectorXd::Zero(count);
  for (Index column = 0; column < count; ++column) {
    for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry) {
      column_sum[column] += std::abs(entry.value());
      if (entry.row() != column) {
        column_sum[entry.row()] += std::abs(entry.value());
      }
    }
  }
  Eigen::VectorXd x = Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count));
  double estimate = 0.0;
  for (int round = 0; round < 4; ++round) {
    const Eigen::VectorXd y = solve(x);
    const double norm = y.lpNorm<1>();
    if (round > 0 && norm <= estimate) {
      break;
    }
    estimate = norm;
    const Eigen::VectorXd z =
        solve(y.unaryExpr([](double value) { return value < 0.0 ? -1.0 : 1.0; }));
    Index largest = 0;
    if (z.cwiseAbs().maxCoeff(&largest) <= z.dot(x) && round > 0) {
      break;
    }
    x.setZero();
    x[largest] = 1.0;
  }
  return estimate * column_sum.maxCoeff();
}

Eigen::VectorXd multiply(const SparseMatrix& lower, const Eigen::VectorXd& x) {
  return lower.selfadjointView<Eigen::Lower>() * x;
}

}  // namespace lapilli
