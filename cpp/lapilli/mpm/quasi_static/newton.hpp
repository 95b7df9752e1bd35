#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace lapilli {

/// How an iteration ended.
struct NewtonReport {
  int iterations = 0;
  double residual = 0.0;   // out-of-balance force over the forces in play
  double floor = 0.0;      // what of it may be rounding
  double reference = 0.0;  // size of the forces in play
  bool converged = false;
};

/// Force out of balance and the size of the forces it is compared with.
struct Imbalance {
  Eigen::VectorXd force;
  double reference = 0.0;
  double rounding = 0.0;  // what of the force may be rounding: stiff parts cancel large terms

  double relative() const { return reference > 0.0 ? force.norm() / reference : force.norm(); }
  double floor() const { return reference > 0.0 ? rounding / reference : 0.0; }
};

/// Newton's method: `residual(u)` gives the imbalance at u, `correction(force)` solves with the
/// tangent there. Runs until the relative imbalance is within `tolerance` or within what rounding
/// leaves, at least two iterations so that the second refines the solve of the first, and stops
/// where a correction no longer helps. `damped`: a correction that makes the imbalance larger is
/// halved, a few times.
template <class Residual, class Correction>
NewtonReport solve_newton(Eigen::VectorXd& u, const Residual& residual,
                          const Correction& correction, double tolerance, int max_iterations,
                          bool damped = false) {
  constexpr int least_iterations = 2, most_halvings = 5;
  NewtonReport report;
  Imbalance imbalance = residual(u);
  report.residual = imbalance.relative();
  double within = std::max(tolerance, imbalance.floor());
  while (report.iterations < max_iterations) {
    if (imbalance.force.isZero(0.0) ||
        (report.residual <= within && report.iterations >= least_iterations)) {
      break;
    }
    const Eigen::VectorXd change = correction(imbalance.force);
    Eigen::VectorXd trial = u + change;
    if (!trial.allFinite()) {
      break;
    }
    Imbalance next = residual(trial);
    ++report.iterations;
    if (damped && report.residual > within) {
      double share = 1.0;
      for (int k = 0; k < most_halvings && !(next.relative() < report.residual); ++k) {
        share *= 0.5;
        trial = u + share * change;
        next = residual(trial);
      }
    }
    // Below the tolerance only rounding moves: keep the better of the two.
    if (report.residual <= within && next.relative() >= report.residual) {
      break;
    }
    u = trial;
    imbalance = std::move(next);
    report.residual = imbalance.relative();
    within = std::max(tolerance, imbalance.floor());
  }
  report.converged = report.residual <= within;
  report.floor = imbalance.floor();
  report.reference = imbalance.reference;
  return report;
}

}  // namespace lapilli
