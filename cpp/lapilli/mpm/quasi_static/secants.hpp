#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <deque>

namespace lapilli {

/// What the last corrections of an iteration did to the forces (multisecant quasi-Newton, Fang &
/// Saad 2009): where the matrix is not quite the tangent, as with the symmetric part of that of
/// flow without dilatancy, they tell the rest.
class Secants {
 public:
  /// The correction at `u`, where `force` is out of balance; `solve(force)` uses the matrix.
  /// `slow`: whether the matrix alone brings too little.
  template <class Solve>
  Eigen::VectorXd correction(const Eigen::VectorXd& u, const Eigen::VectorXd& force, bool slow,
                             const Solve& solve) {
    constexpr std::size_t kept = 12;
    if (last_force_.size() == force.size()) {
      moves_.push_back(u - last_u_);
      changes_.push_back(force - last_force_);
    }
    if (moves_.size() > kept) {
      moves_.pop_front();
      changes_.pop_front();
    }
    last_u_ = u;
    last_force_ = force;
    if (!slow || moves_.empty()) {
      return solve(force);
    }
    const auto count = static_cast<Eigen::Index>(moves_.size());
    Eigen::MatrixXd moves(u.size(), count), changes(u.size(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
      moves.col(k) = moves_[static_cast<std::size_t>(k)];
      changes.col(k) = changes_[static_cast<std::size_t>(k)];
    }
    const Eigen::VectorXd share = changes.colPivHouseholderQr().solve(force);
    return solve(Eigen::VectorXd(force - changes * share)) - moves * share;
  }

 private:
  std::deque<Eigen::VectorXd> moves_, changes_;
  Eigen::VectorXd last_u_, last_force_;
};

}  // namespace lapilli
