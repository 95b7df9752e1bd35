#include "lapilli/mpm/dynamics/obstacles/rigid_motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace lapilli {

RigidMotion::RigidMotion(const Obstacle& obstacle)
    : factor_(obstacle.factor), rate_(2.0 * std::numbers::pi * obstacle.revolutions_per_second) {
  std::copy(obstacle.velocity.begin(), obstacle.velocity.end(), speed_.data());
  std::copy(obstacle.center.begin(), obstacle.center.end(), center_.data());
  axis_ = Eigen::Map<const Vec3>(obstacle.axis.data()).normalized();
  set_time(0.0);
}

void RigidMotion::advance(double time, double span) {
  const double share = span * factor_.at(time + 0.5 * span);
  displacement_ += share * speed_;
  angle_ += share * rate_;
}

void RigidMotion::set_time(double time) { present_ = factor_.at(time); }

Vec3 RigidMotion::reference(const Vec3& x) const {
  const Vec3 arm = x - center_ - displacement_;
  return center_ + (angle_ == 0.0 ? arm : Eigen::AngleAxisd(-angle_, axis_) * arm);
}

Vec3 RigidMotion::turned(const Vec3& direction) const {
  return angle_ == 0.0 ? direction : Eigen::AngleAxisd(angle_, axis_) * direction;
}

Vec3 RigidMotion::velocity(const Vec3& x) const {
  return present_ * (speed_ + rate_ * axis_.cross(x - center_ - displacement_));
}

double RigidMotion::speed(double reach) const {
  return std::abs(present_) * (speed_.norm() + std::abs(rate_) * reach);
}

std::array<double, 5> RigidMotion::state() const {
  return {displacement_[0], displacement_[1], displacement_[2], angle_, present_};
}

void RigidMotion::restore(const std::array<double, 5>& state) {
  displacement_ = {state[0], state[1], state[2]};
  angle_ = state[3];
  present_ = state[4];
}

}  // namespace lapilli
