#pragma once

#include <array>

#include "lapilli/core/vector.hpp"
#include "lapilli/mpm/dynamics/obstacles/obstacle.hpp"

namespace lapilli {

/// Where a rigid obstacle is and how fast it moves: turned by `angle` about a centre that has moved
/// by `displacement` since the start.
class RigidMotion {
 public:
  explicit RigidMotion(const Obstacle& obstacle);

  /// Move on from `time` over `span`, s: with the mean of the factor, exact where a table is
  /// linear.
  void advance(double time, double span);
  /// Take the velocities of this time.
  void set_time(double time);

  /// The place of the undisplaced shape that `x` stands for.
  Vec3 reference(const Vec3& x) const;
  /// A direction of the undisplaced shape in space.
  Vec3 turned(const Vec3& direction) const;
  /// Velocity of the obstacle's matter at `x`, m/s.
  Vec3 velocity(const Vec3& x) const;
  Vec3 center() const { return center_ + displacement_; }

  /// Largest speed within `reach` of the centre at the present time, m/s.
  double speed(double reach) const;
  bool moves() const { return speed_ != Vec3(Vec3::Zero()) || rate_ != 0.0; }

  /// Displacement, angle and the present factor.
  std::array<double, 5> state() const;
  void restore(const std::array<double, 5>& state);

 private:
  Value factor_;
  Vec3 speed_ = Vec3::Zero(), center_ = Vec3::Zero(), axis_ = Vec3::UnitZ();
  double rate_ = 0.0;     // rad/s
  double present_ = 1.0;  // the factor now
  Vec3 displacement_ = Vec3::Zero();
  double angle_ = 0.0;
};

}  // namespace lapilli
