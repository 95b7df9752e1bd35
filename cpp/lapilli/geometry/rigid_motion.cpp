#include "lapilli/geometry/rigid_motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/bounds.hpp"

namespace lapilli {
namespace {

constexpr double least = 1e-12;  // of a length

Vec3 axis_of(const Rotation& turn, int dimension) {
  return dimension == 3 ? Vec3(place(turn.axis).normalized()) : Vec3(Vec3::UnitZ());
}

/// How far a place lies from the axis of a rotation, m.
double off_axis(const Rotation& turn, const Vec3& at, int dimension) {
  return axis_of(turn, dimension).cross(at - place(turn.center)).norm();
}

bool is_along(const Vec3& direction, const Vec3& axis) {
  return direction.cross(axis).norm() <= least * direction.norm() * axis.norm();
}

bool turns_into_itself(const Rotation& turn, const Shape& region, int dimension) {
  const auto on_axis = [&](const std::vector<double>& at, double size) {
    return off_axis(turn, place(at), dimension) <= least * size;
  };
  if (const auto* disk = std::get_if<Disk>(&region)) {
    return on_axis(disk->center, disk->radius);
  }
  if (const auto* ring = std::get_if<Annulus>(&region)) {
    return on_axis(ring->center, ring->outer);
  }
  if (const auto* ball = std::get_if<Sphere>(&region)) {
    return on_axis(ball->center, ball->radius);
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&region)) {
    return on_axis(cylinder->start, cylinder->radius) && on_axis(cylinder->end, cylinder->radius);
  }
  const auto* half = std::get_if<HalfSpace>(&region);
  return half != nullptr && is_along(place(half->normal), axis_of(turn, dimension));
}

bool shifts_into_itself(const Translation& line, const Shape& region) {
  const Vec3 velocity = place(line.velocity);
  const auto* half = std::get_if<HalfSpace>(&region);
  return velocity.isZero(0.0) ||
         (half != nullptr && std::abs(velocity.dot(place(half->normal))) <=
                                 least * velocity.norm() * place(half->normal).norm());
}

}  // namespace

bool is_rigid(const Motion& motion) { return !std::holds_alternative<Swirl>(motion); }

Placement placement_at(const Motion& motion, double time, int dimension) {
  Placement at;
  if (const auto* turn = std::get_if<Rotation>(&motion)) {
    const double angle = 2.0 * std::numbers::pi * turn->revolutions_per_second * time;
    at.turn = Eigen::AngleAxisd(angle, axis_of(*turn, dimension)).toRotationMatrix();
    at.shift = place(turn->center) - at.turn * place(turn->center);
  } else {
    const auto* line = std::get_if<Translation>(&motion);
    require(line != nullptr, "a swirl has no rigid placement");
    at.shift = time * place(line->velocity);
  }
  return at;
}

bool is_same(const Motion& first, const Motion& second) {
  if (const auto* a = std::get_if<Rotation>(&first), *b = std::get_if<Rotation>(&second); a && b) {
    return a->revolutions_per_second == b->revolutions_per_second &&
           place(a->center) == place(b->center) && a->axis == b->axis;
  }
  const auto *a = std::get_if<Translation>(&first), *b = std::get_if<Translation>(&second);
  return a != nullptr && b != nullptr && place(a->velocity) == place(b->velocity);
}

bool carries_into_itself(const Motion& motion, const Shape& region, int dimension) {
  const auto all = [&](std::span<const Shape> shapes) {
    return std::all_of(shapes.begin(), shapes.end(), [&](const Shape& shape) {
      return carries_into_itself(motion, shape, dimension);
    });
  };
  if (const auto* some = std::get_if<Union>(&region)) {
    return all(some->shapes);
  }
  if (const auto* some = std::get_if<Intersection>(&region)) {
    return all(some->shapes);
  }
  if (const auto* cut = std::get_if<Difference>(&region)) {
    return carries_into_itself(motion, *cut->shape, dimension) &&
           carries_into_itself(motion, *cut->minus, dimension);
  }
  if (const auto* turn = std::get_if<Rotation>(&motion)) {
    return turns_into_itself(*turn, region, dimension);
  }
  const auto* line = std::get_if<Translation>(&motion);
  return line != nullptr && shifts_into_itself(*line, region);
}

}  // namespace lapilli
