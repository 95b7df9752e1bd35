#include "lapilli/geometry/step_of_motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lapilli/geometry/bounds.hpp"

namespace lapilli {
namespace {

/// How fast a point moves, m/s, and turns, 1/s.
struct Pace {
  double speed = 0.0, turns = 0.0;
};

Pace turning(double turns, double radius) {
  return {2.0 * std::numbers::pi * std::abs(turns) * radius, std::abs(turns)};
}

Pace pace_of(const Rotation& motion, const Vec3& at, int dimension) {
  const Vec3 away = at - place(motion.center);
  const Vec3 axis = dimension == 3 ? Vec3(place(motion.axis).normalized()) : Vec3(Vec3::UnitZ());
  return turning(motion.revolutions_per_second, axis.cross(away).norm());
}

Pace pace_of(const Translation& motion, const Vec3&, int) {
  return {place(motion.velocity).norm(), 0.0};
}

Pace pace_of(const Swirl& motion, const Vec3& at, int) {
  const double radius = (at - place(motion.center)).norm(), share = radius / motion.radius;
  return turning(motion.revolutions_per_second * (1.0 + motion.shear * (1.0 - share * share)),
                 radius);
}

}  // namespace

template <int Dim>
double step_of_motion(const Points& points, const std::vector<std::optional<Motion>>& motions,
                      double cell) {
  Pace most;
  for (Index row = 0; row < points.size(); ++row) {
    const auto& motion = motions[static_cast<std::size_t>(points.body()[row])];
    if (!motion) {
      continue;
    }
    Vec3 at = Vec3::Zero();
    at.head<Dim>() = points.position<Dim>(row);
    const Pace pace = std::visit([&](const auto& m) { return pace_of(m, at, Dim); }, *motion);
    most = {std::max(most.speed, pace.speed), std::max(most.turns, pace.turns)};
  }
  const auto over = [](double share, double rate) {
    return rate > 0.0 ? share / rate : std::numeric_limits<double>::infinity();
  };
  return std::min(over(cells_in_a_step * cell, most.speed), over(turns_in_a_step, most.turns));
}

template double step_of_motion<1>(const Points&, const std::vector<std::optional<Motion>>&, double);
template double step_of_motion<2>(const Points&, const std::vector<std::optional<Motion>>&, double);
template double step_of_motion<3>(const Points&, const std::vector<std::optional<Motion>>&, double);

}  // namespace lapilli
