#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/mpm/dynamics/obstacles/rigid_mass.hpp"

namespace lapilli {

/// Where a rigid obstacle is and how fast it moves: by a prescribed motion about a centre, or, with
/// a mass, by the forces on it.
class RigidMotion {
 public:
  RigidMotion(const Obstacle& obstacle, int dimension, const std::string& where);

  bool is_free() const { return free_.has_value(); }

  /// Move on from `time` over `span`, s: a prescribed motion with the mean of the factor; a free
  /// one with its present velocity.
  void advance(double time, double span);
  /// Take the mean velocities of this span, where they are prescribed; those at `time` where it is
  /// empty.
  void set_span(double time, double span);

  // Of a free motion, one step: the forces but those of contacts, the impulses of contacts, the way
  // with the mean of the velocities before and after, so that its energy is exact.

  void accelerate(double time, double span, const Vec3& gravity);
  void push(const Vec3& impulse, const Vec3& moment);  // N s, N m s about the centre
  /// `done` of the span has been moved by `advance` with the velocity before.
  void finish(double span, double done);
  /// A share of the change of velocity of the step against the velocity, no more than halts it.
  void damp(double share);

  /// The place of the undisplaced shape that `x` stands for.
  Vec3 reference(const Vec3& x) const { return center_ + turn_.transpose() * (x - center()); }
  /// A direction of the undisplaced shape in space.
  Vec3 turned(const Vec3& direction) const { return turn_ * direction; }
  /// Velocity of the obstacle's matter at `x`, m/s.
  Vec3 velocity(const Vec3& x) const { return velocity_ + spin_.cross(x - center()); }
  /// The mean of those before and after a step.
  Vec3 mean_velocity(const Vec3& x) const;
  Vec3 center() const { return center_ + displacement_; }

  /// Largest speed within `reach` of the centre at the present time, m/s.
  double speed(double reach) const { return velocity_.norm() + spin_.norm() * reach; }
  // What an impulse can change at most; 0 where the motion is prescribed.
  double inverse_mass() const { return free_ ? free_->inverse_mass.maxCoeff() : 0.0; }  // 1/kg
  /// 1/(kg m2)
  double inverse_inertia() const { return free_ ? free_->greatest_inverse_inertia : 0.0; }

  const Vec3& velocity_of_center() const { return velocity_; }  // m/s
  const Vec3& spin() const { return spin_; }                    // rad/s
  double angle() const { return angle_; }                       // rad, in the plane
  double kinetic_energy() const;                                // J, of a free one

  void save(Archive& archive, const std::string& prefix) const;
  void load(const Archive& archive, const std::string& prefix);
  /// The same of a stage before, in which mass, shape or what is held may have been others: place,
  /// velocity and spin go on.
  void go_on(const Archive& archive, const std::string& prefix);

 private:
  struct Free {
    double mass = 0.0;                      // kg
    Vec3 inverse_mass = Vec3::Zero();       // 1/kg along each axis; 0: held
    Mat3 inertia = Mat3::Zero();            // kg m2, at the start
    Mat3 inverse_inertia = Mat3::Zero();    // at the start; 0: held
    double greatest_inverse_inertia = 0.0;  // its largest eigenvalue, 1/(kg m2)
    std::vector<Value> force;               // N
    Vec3 angular_momentum = Vec3::Zero(), velocity_before = Vec3::Zero(),
         spin_before = Vec3::Zero();
  };

  void turn_by(const Vec3& angles);
  void update_spin();
  Vec3 momentum_of_spin() const;

  Value factor_;
  Vec3 speed_ = Vec3::Zero(), center_ = Vec3::Zero(), axis_ = Vec3::UnitZ();
  double rate_ = 0.0;  // rad/s
  std::optional<Free> free_;
  Vec3 displacement_ = Vec3::Zero(), velocity_ = Vec3::Zero(), spin_ = Vec3::Zero();
  double angle_ = 0.0;
  Mat3 turn_ = Mat3::Identity();
};

}  // namespace lapilli
