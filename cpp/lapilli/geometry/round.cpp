#include "lapilli/geometry/round.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lapilli/geometry/checks.hpp"

namespace lapilli {
namespace {

Vec3 in_plane(const Vec3& x, const std::vector<double>& center) {
  return {x[0] - center[0], x[1] - center[1], 0.0};
}

// The centre itself has no outward direction; any unit vector serves.
Vec3 direction(const Vec3& from_center) {
  const double length = from_center.norm();
  return length > 0.0 ? Vec3(from_center / length) : Vec3(Vec3::UnitX());
}

Bounds circle_bounds(const std::vector<double>& center, double radius) {
  Bounds all;
  for (int axis = 0; axis < 2; ++axis) {
    all.lower[axis] = center[static_cast<std::size_t>(axis)] - radius;
    all.upper[axis] = center[static_cast<std::size_t>(axis)] + radius;
  }
  return all;
}

// Where a point lies relative to a cylinder: along the axis from its middle, and off the axis.
struct AxisFrame {
  AxisFrame(const Cylinder& cylinder, const Vec3& x) {
    const Vec3 start = place(cylinder.start), end = place(cylinder.end);
    axis = (end - start).normalized();
    half_length = 0.5 * (end - start).norm();
    const Vec3 from_middle = x - 0.5 * (start + end);
    along = from_middle.dot(axis);
    off_axis = from_middle - along * axis;
    beyond_end = std::abs(along) - half_length;
    beyond_side = off_axis.norm() - cylinder.radius;
  }
  Vec3 axis, off_axis;
  double half_length, along, beyond_end, beyond_side;
};

}  // namespace

double Disk::distance(const Vec3& x) const { return in_plane(x, center).norm() - radius; }

Vec3 Disk::gradient(const Vec3& x) const { return direction(in_plane(x, center)); }

Bounds Disk::bounds() const { return circle_bounds(center, radius); }

void Disk::check(int dimension) const {
  require_dimension(dimension, 2, kind, "a box");
  require_numbers(center, 2, 2, kind, "center");
  require_positive(radius, kind, "radius");
}

double Annulus::distance(const Vec3& x) const {
  const double r = in_plane(x, center).norm();
  return std::max(inner - r, r - outer);
}

Vec3 Annulus::gradient(const Vec3& x) const {
  const Vec3 from_center = in_plane(x, center);
  const double r = from_center.norm();
  return inner - r > r - outer ? Vec3(-direction(from_center)) : direction(from_center);
}

Bounds Annulus::bounds() const { return circle_bounds(center, outer); }

void Annulus::check(int dimension) const {
  require_dimension(dimension, 2, kind, "a box");
  require_numbers(center, 2, 2, kind, "center");
  require_positive(inner, kind, "inner");
  require_positive(outer, kind, "outer");
  require(inner < outer, "annulus: inner must be smaller than outer, got ", inner, " and ", outer);
}

double Sphere::distance(const Vec3& x) const { return (x - place(center)).norm() - radius; }

Vec3 Sphere::gradient(const Vec3& x) const { return direction(x - place(center)); }

Bounds Sphere::bounds() const {
  return {place(center) - Vec3::Constant(radius), place(center) + Vec3::Constant(radius)};
}

void Sphere::check(int dimension) const {
  require_dimension(dimension, 3, kind, "a disk");
  require_numbers(center, 3, 3, kind, "center");
  require_positive(radius, kind, "radius");
}

double Cylinder::distance(const Vec3& x) const {
  const AxisFrame at(*this, x);
  if (at.beyond_end > 0.0 && at.beyond_side > 0.0) {
    return std::hypot(at.beyond_end, at.beyond_side);
  }
  return std::max(at.beyond_end, at.beyond_side);
}

Vec3 Cylinder::gradient(const Vec3& x) const {
  const AxisFrame at(*this, x);
  const Vec3 end_normal = at.along < 0.0 ? Vec3(-at.axis) : at.axis;
  const Vec3 side_normal =
      at.off_axis.norm() > 0.0 ? Vec3(at.off_axis.normalized()) : at.axis.unitOrthogonal();
  if (at.beyond_end > 0.0 && at.beyond_side > 0.0) {
    return (at.beyond_end * end_normal + at.beyond_side * side_normal).normalized();
  }
  return at.beyond_end > at.beyond_side ? end_normal : side_normal;
}

Bounds Cylinder::bounds() const {
  const Vec3 from = place(start), to = place(end);
  const Vec3 axis = (to - from).normalized();
  // Half extent of the rim along each coordinate.
  const Vec3 rim = radius * (1.0 - axis.array().square()).max(0.0).sqrt().matrix();
  return {from.cwiseMin(to) - rim, from.cwiseMax(to) + rim};
}

void Cylinder::check(int dimension) const {
  require_dimension(dimension, 3, kind, "a disk or a box");
  require_numbers(start, 3, 3, kind, "start");
  require_numbers(end, 3, 3, kind, "end");
  require_positive(radius, kind, "radius");
  require((place(end) - place(start)).norm() > 0.0,
          "cylinder: start and end must differ, both are ", text_of(start));
}

}  // namespace lapilli
