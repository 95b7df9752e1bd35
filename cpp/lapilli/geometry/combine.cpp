#include "lapilli/geometry/combine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {
namespace {

// The shape whose distance is the least (greatest) decides.
template <class Better>
const Shape& deciding(const std::vector<Shape>& shapes, const Vec3& x, Better better) {
  const Shape* best = &shapes.front();
  double best_distance = lapilli::distance(*best, x);
  for (std::size_t k = 1; k < shapes.size(); ++k) {
    const double candidate = lapilli::distance(shapes[k], x);
    if (better(candidate, best_distance)) {
      best = &shapes[k];
      best_distance = candidate;
    }
  }
  return *best;
}

void check_all(const std::vector<Shape>& shapes, int dimension, const char* kind) {
  require(!shapes.empty(), kind, ": shapes needs at least one shape");
  for (const Shape& shape : shapes) {
    lapilli::check(shape, dimension);
  }
}

void check_given(const Nested& shape, int dimension, const char* kind, const char* member) {
  require(!shape.empty(), kind, ": ", member, " must be given");
  lapilli::check(*shape, dimension);
}

}  // namespace

Nested::Nested(Shape shape) : shape_(std::make_shared<const Shape>(std::move(shape))) {}

double Union::distance(const Vec3& x) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Shape& shape : shapes) {
    least = std::min(least, lapilli::distance(shape, x));
  }
  return least;
}

Vec3 Union::gradient(const Vec3& x) const {
  return lapilli::gradient(deciding(shapes, x, std::less<>()), x);
}

Bounds Union::bounds() const {
  Bounds all = lapilli::bounds(shapes.front());
  for (const Shape& shape : shapes) {
    const Bounds one = lapilli::bounds(shape);
    all.lower = all.lower.cwiseMin(one.lower);
    all.upper = all.upper.cwiseMax(one.upper);
  }
  return all;
}

void Union::check(int dimension) const { check_all(shapes, dimension, kind); }

double Intersection::distance(const Vec3& x) const {
  double most = -std::numeric_limits<double>::infinity();
  for (const Shape& shape : shapes) {
    most = std::max(most, lapilli::distance(shape, x));
  }
  return most;
}

Vec3 Intersection::gradient(const Vec3& x) const {
  return lapilli::gradient(deciding(shapes, x, std::greater<>()), x);
}

Bounds Intersection::bounds() const {
  Bounds all;
  for (const Shape& shape : shapes) {
    const Bounds one = lapilli::bounds(shape);
    all.lower = all.lower.cwiseMax(one.lower);
    all.upper = all.upper.cwiseMin(one.upper);
  }
  return all;
}

void Intersection::check(int dimension) const { check_all(shapes, dimension, kind); }

double Difference::distance(const Vec3& x) const {
  return std::max(lapilli::distance(*shape, x), -lapilli::distance(*minus, x));
}

Vec3 Difference::gradient(const Vec3& x) const {
  if (lapilli::distance(*shape, x) >= -lapilli::distance(*minus, x)) {
    return lapilli::gradient(*shape, x);
  }
  return -lapilli::gradient(*minus, x);
}

Bounds Difference::bounds() const { return lapilli::bounds(*shape); }

void Difference::check(int dimension) const {
  check_given(shape, dimension, kind, "shape");
  check_given(minus, dimension, kind, "minus");
}

Mat3 Rotated::matrix() const { return rotation(degrees, place(axis)); }

Vec3 Rotated::before(const Vec3& x) const {
  const Vec3 fixed = place(center);
  return fixed + matrix().transpose() * (x - fixed);
}

double Rotated::distance(const Vec3& x) const { return lapilli::distance(*shape, before(x)); }

Vec3 Rotated::gradient(const Vec3& x) const {
  return matrix() * lapilli::gradient(*shape, before(x));
}

Bounds Rotated::bounds() const {
  const Bounds inner = lapilli::bounds(*shape);
  const Mat3 turn = matrix();
  const Vec3 fixed = place(center);
  Bounds all{fixed, fixed};
  // Axis by axis, so that an infinite axis makes infinite only what it reaches.
  for (int row = 0; row < 3; ++row) {
    for (int axis_index = 0; axis_index < 3; ++axis_index) {
      const double weight = turn(row, axis_index);
      if (weight == 0.0) {
        continue;
      }
      const double from = weight * (inner.lower[axis_index] - fixed[axis_index]);
      const double to = weight * (inner.upper[axis_index] - fixed[axis_index]);
      all.lower[row] += std::min(from, to);
      all.upper[row] += std::max(from, to);
    }
  }
  return all;
}

void Rotated::check(int dimension) const {
  require(dimension >= 2, "rotated: a grid of 1 dimension has no rotation");
  require(std::isfinite(degrees), "rotated: degrees must be finite, got ", degrees);
  require_numbers(center, 0, static_cast<std::size_t>(dimension), kind, "center");
  require_numbers(axis, 3, 3, kind, "axis");
  require(place(axis).norm() > 0.0, "rotated: axis must not be zero");
  require(dimension == 3 || (axis[0] == 0.0 && axis[1] == 0.0),
          "rotated: in 2 dimensions the axis is (0, 0, 1), got ", text_of(axis));
  check_given(shape, dimension, kind, "shape");
}

double Translated::distance(const Vec3& x) const {
  return lapilli::distance(*shape, x - place(by));
}

Vec3 Translated::gradient(const Vec3& x) const { return lapilli::gradient(*shape, x - place(by)); }

Bounds Translated::bounds() const {
  const Bounds inner = lapilli::bounds(*shape);
  return {inner.lower + place(by), inner.upper + place(by)};
}

void Translated::check(int dimension) const {
  require_numbers(by, 1, static_cast<std::size_t>(dimension), kind, "by");
  check_given(shape, dimension, kind, "shape");
}

Mat3 rotation(double degrees, const Vec3& axis) {
  const double turn = std::remainder(degrees, 360.0);
  const double radians = turn * std::numbers::pi / 180.0;
  double c = std::cos(radians), s = std::sin(radians);
  if (std::remainder(turn, 90.0) == 0.0) {
    c = std::round(c);
    s = std::round(s);
  }
  const Vec3 n = axis.normalized();
  Mat3 cross;
  cross << 0.0, -n[2], n[1], n[2], 0.0, -n[0], -n[1], n[0], 0.0;
  return c * Mat3::Identity() + s * cross + (1.0 - c) * n * n.transpose();
}

}  // namespace lapilli
