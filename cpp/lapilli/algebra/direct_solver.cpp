#include "lapilli/algebra/direct_solver.hpp"

#include <algorithm>
#include <limits>

#ifdef LAPILLI_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include "lapilli/algebra/multifrontal.hpp"
#endif

namespace lapilli {

#ifdef LAPILLI_CHOLMOD

namespace {

/// The supernodal factor of CHOLMOD, with its diagonal in view.
class Supernodal : public Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> {
 public:
  /// Squares of the diagonal of L, by unknown; not a number from the first bad pivot on.
  Eigen::VectorXd pivots() const {
    const cholmod_factor& factor = *m_cholmodFactor;
    Eigen::VectorXd all = Eigen::VectorXd::Constant(static_cast<Index>(factor.n),
                                                    std::numeric_limits<double>::quiet_NaN());
    const auto* super = static_cast<const int*>(factor.super);
    const auto* rows = static_cast<const int*>(factor.pi);
    const auto* values = static_cast<const int*>(factor.px);
    const auto* unknown = static_cast<const int*>(factor.Perm);
    const auto* entries = static_cast<const double*>(factor.x);
    for (std::size_t k = 0; k < factor.nsuper; ++k) {
      const Index height = rows[k + 1] - rows[k];
      for (int column = super[k]; column < super[k + 1]; ++column) {
        const double entry = entries[values[k] + (column - super[k]) * (height + 1)];
        if (static_cast<std::size_t>(column) < factor.minor) {
          all[unknown[column]] = entry * entry;
        }
      }
    }
    return all;
  }
};

}  // namespace

/// CHOLMOD with its own ordering and supernodes.
struct DirectSolver::Factor {
  Supernodal llt;
  Eigen::VectorXd pivots;

  void analyse(const SparseMatrix& lower, std::span<const int>) { llt.analyzePattern(lower); }
  void factorise(const SparseMatrix& lower) {
    llt.factorize(lower);
    pivots = llt.pivots();
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const { return llt.solve(right_side); }
};

#else

struct DirectSolver::Factor {
  Multifrontal fronts;
  Eigen::VectorXd pivots;

  void analyse(const SparseMatrix& lower, std::span<const int> part_start) {
    fronts.analyse(lower, part_start);
  }
  void factorise(const SparseMatrix& lower) {
    fronts.factorise(lower);
    pivots = fronts.pivots();
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const {
    return fronts.solve(right_side);
  }
};

#endif

DirectSolver::DirectSolver() : factor_(std::make_unique<Factor>()) {}
DirectSolver::~DirectSolver() = default;

void DirectSolver::analyse(const SparseMatrix& lower, std::span<const int> part_start) {
  factor_->analyse(lower, part_start);
}

PivotReport DirectSolver::factorise(const SparseMatrix& lower) {
  factor_->factorise(lower);
  PivotReport report;
  report.smallest = std::numeric_limits<double>::infinity();
  const Eigen::VectorXd& pivots = factor_->pivots;
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
  return factor_->solve(right_side);
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

}  // namespace lapilli
