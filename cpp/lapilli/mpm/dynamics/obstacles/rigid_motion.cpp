#include "lapilli/mpm/dynamics/obstacles/rigid_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lapilli/core/symmetric_modes.hpp"

namespace lapilli {
namespace {

bool is_held(const Obstacle& obstacle, const char* what) {
  return std::ranges::find(obstacle.held, what) != obstacle.held.end();
}

/// The inverse where there is an inertia: in the plane about z only.
Mat3 inverse_of(const Mat3& inertia, int dimension) {
  if (dimension == 3) {
    return inertia.inverse();
  }
  Mat3 inverse = Mat3::Zero();
  inverse(2, 2) = 1.0 / inertia(2, 2);
  return inverse;
}

}  // namespace

RigidMotion::RigidMotion(const Obstacle& obstacle, int dimension, const std::string& where)
    : factor_(obstacle.factor), rate_(2.0 * std::numbers::pi * obstacle.revolutions_per_second) {
  std::copy(obstacle.velocity.begin(), obstacle.velocity.end(), speed_.data());
  std::copy(obstacle.center.begin(), obstacle.center.end(), center_.data());
  axis_ = Eigen::Map<const Vec3>(obstacle.axis.data()).normalized();
  set_span(0.0, 0.0);
  if (!obstacle.mass) {
    return;
  }
  const RigidMass known = rigid_mass(obstacle, dimension, where);
  center_ = known.center;
  Free free;
  free.mass = known.mass;
  constexpr const char* axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < dimension; ++axis) {
    free.inverse_mass[axis] = is_held(obstacle, axes[axis]) ? 0.0 : 1.0 / known.mass;
  }
  free.inertia = known.inertia;
  free.angular_momentum = known.inertia * spin_;
  if (!is_held(obstacle, "rotation")) {
    free.inverse_inertia = inverse_of(known.inertia, dimension);
    free.greatest_inverse_inertia = symmetric_modes<3>(free.inverse_inertia).eigenvalues.maxCoeff();
  }
  free.force = obstacle.force;
  free.velocity_before = velocity_;
  free.spin_before = spin_;
  free_ = free;
}

void RigidMotion::advance(double time, double span) {
  if (free_) {
    displacement_ += span * velocity_;
    turn_by(span * spin_);
    return;
  }
  const double share = span * factor_.mean(time, time + span);
  displacement_ += share * speed_;
  angle_ += share * rate_;
  turn_ = angle_ == 0.0 ? Mat3(Mat3::Identity()) : Eigen::AngleAxisd(angle_, axis_).matrix();
}

void RigidMotion::set_span(double time, double span) {
  if (!free_) {
    const double mean = factor_.mean(time, time + span);
    velocity_ = mean * speed_;
    spin_ = mean * rate_ * axis_;
  }
}

void RigidMotion::accelerate(double time, double span, const Vec3& gravity) {
  free_->velocity_before = velocity_;
  free_->spin_before = spin_;
  Vec3 impulse = span * free_->mass * gravity;
  for (std::size_t axis = 0; axis < free_->force.size(); ++axis) {
    impulse[static_cast<Index>(axis)] += span * free_->force[axis].mean(time, time + span);
  }
  velocity_ += free_->inverse_mass.cwiseProduct(impulse);
}

void RigidMotion::push(const Vec3& impulse, const Vec3& moment) {
  velocity_ += free_->inverse_mass.cwiseProduct(impulse);
  free_->angular_momentum += moment;
  update_spin();
}

/// The turn by the spins at both ends of the step, of which the second follows from it: in space,
/// where the spin of a free body changes as it turns, the energy stays.
void RigidMotion::finish(double span, double done) {
  displacement_ += 0.5 * span * velocity_ + (0.5 * span - done) * free_->velocity_before;
  turn_by((0.5 * span - done) * free_->spin_before);
  const Mat3 middle = turn_;
  const double angle = angle_;
  constexpr int iterations = 4;
  for (int k = 0; k < iterations; ++k) {
    turn_ = middle;
    angle_ = angle;
    turn_by(0.5 * span * spin_);
    update_spin();
  }
}

void RigidMotion::damp(double share) {
  const auto against = [share](const Vec3& after, const Vec3& before) -> Vec3 {
    const Vec3 mean = 0.5 * (after + before);
    const double speed = mean.norm();
    return speed > 0.0 ? Vec3(-std::min(share * (after - before).norm() / speed, 1.0) * mean)
                       : Vec3(Vec3::Zero());
  };
  const Vec3 free_axes = free_->mass * free_->inverse_mass;
  velocity_ += free_axes.cwiseProduct(against(velocity_, free_->velocity_before));
  if (free_->greatest_inverse_inertia > 0.0) {
    const double share_of_spin = against(spin_, free_->spin_before).norm();
    const double now = spin_.norm();
    if (now > 0.0) {
      free_->angular_momentum *= std::max(0.0, 1.0 - share_of_spin / now);
      update_spin();
    }
  }
}

Vec3 RigidMotion::mean_velocity(const Vec3& x) const {
  if (!free_) {
    return velocity(x);
  }
  const Vec3 spin = 0.5 * (spin_ + free_->spin_before);
  return 0.5 * (velocity_ + free_->velocity_before) + spin.cross(x - center());
}

/// Where the spin is held, the moments of contacts change the account of momentum but not the spin.
double RigidMotion::kinetic_energy() const {
  if (!free_) {
    return 0.0;
  }
  const bool spins_on = free_->greatest_inverse_inertia == 0.0;
  const Vec3 momentum = spins_on ? momentum_of_spin() : free_->angular_momentum;
  return 0.5 * free_->mass * velocity_.squaredNorm() + 0.5 * spin_.dot(momentum);
}

Vec3 RigidMotion::momentum_of_spin() const {
  return turn_ * (free_->inertia * (turn_.transpose() * spin_));
}

void RigidMotion::turn_by(const Vec3& angles) {
  const double angle = angles.norm();
  if (angle > 0.0) {
    turn_ = Eigen::AngleAxisd(angle, angles / angle) * turn_;
    angle_ += angles[2];
  }
}

/// Angular momentum stays, the spin follows as the body turns; one that is held stays itself.
void RigidMotion::update_spin() {
  if (free_->greatest_inverse_inertia == 0.0) {
    return;
  }
  spin_ = turn_ * (free_->inverse_inertia * (turn_.transpose() * free_->angular_momentum));
}

void RigidMotion::save(Archive& archive, const std::string& prefix) const {
  std::vector<double> numbers{angle_};
  for (const Vec3* vector : {&displacement_, &velocity_, &spin_}) {
    numbers.insert(numbers.end(), vector->data(), vector->data() + 3);
  }
  numbers.insert(numbers.end(), turn_.data(), turn_.data() + 9);
  if (free_) {
    numbers.insert(numbers.end(), free_->angular_momentum.data(),
                   free_->angular_momentum.data() + 3);
  }
  archive.write(prefix + "/motion", std::span<const double>(numbers));
}

void RigidMotion::load(const Archive& archive, const std::string& prefix) {
  std::vector<double> numbers(free_ ? 22 : 19);
  archive.read(prefix + "/motion", std::span<double>(numbers));
  const double* from = numbers.data();
  angle_ = *from++;
  for (Vec3* vector : {&displacement_, &velocity_, &spin_}) {
    std::copy_n(from, 3, vector->data());
    from += 3;
  }
  std::copy_n(from, 9, turn_.data());
  if (free_) {
    std::copy_n(from + 9, 3, free_->angular_momentum.data());
    free_->velocity_before = velocity_;
    free_->spin_before = spin_;
  }
}

void RigidMotion::go_on(const Archive& archive, const std::string& prefix) {
  load(archive, prefix);
  if (!free_) {
    return;
  }
  constexpr double rounding = 1e-9;
  const Vec3 momentum = momentum_of_spin();
  if (!((free_->angular_momentum - momentum).norm() <= rounding * momentum.norm())) {
    free_->angular_momentum = momentum;
  }
}

}  // namespace lapilli
