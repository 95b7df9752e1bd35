#include "lapilli/geometry/box.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/geometry/checks.hpp"

namespace lapilli {

double Box::distance(const Vec3& x) const {
  double deepest = -std::numeric_limits<double>::infinity();
  double outside_squared = 0.0;
  for (std::size_t axis = 0; axis < lower.size(); ++axis) {
    const double at = x[static_cast<int>(axis)];
    const double beyond = std::max(lower[axis] - at, at - upper[axis]);
    deepest = std::max(deepest, beyond);
    outside_squared += beyond > 0.0 ? beyond * beyond : 0.0;
  }
  return deepest > 0.0 ? std::sqrt(outside_squared) : deepest;
}

Vec3 Box::gradient(const Vec3& x) const {
  Vec3 outward = Vec3::Zero();
  double deepest = -std::numeric_limits<double>::infinity();
  Vec3 nearest_face = Vec3::UnitX();
  for (std::size_t k = 0; k < lower.size(); ++k) {
    const int axis = static_cast<int>(k);
    const double below = lower[k] - x[axis], above = x[axis] - upper[k];
    const double beyond = std::max(below, above);
    const double sign = below > above ? -1.0 : 1.0;
    outward[axis] = sign * std::max(beyond, 0.0);
    if (beyond > deepest) {
      deepest = beyond;
      nearest_face = sign * Vec3::Unit(axis);
    }
  }
  return deepest > 0.0 ? Vec3(outward.normalized()) : nearest_face;
}

Bounds Box::bounds() const {
  Bounds all;
  for (std::size_t axis = 0; axis < lower.size(); ++axis) {
    all.lower[static_cast<int>(axis)] = lower[axis];
    all.upper[static_cast<int>(axis)] = upper[axis];
  }
  return all;
}

void Box::check(int dimension) const {
  const auto most = static_cast<std::size_t>(dimension);
  for (const auto* corner : {&lower, &upper}) {
    require(!corner->empty() && corner->size() <= most,
            "box: ", corner == &lower ? "lower" : "upper", " needs 1 to ", most, " numbers, got ",
            corner->size(), ": ", text_of(*corner));
  }
  require(lower.size() == upper.size(), "box: lower and upper need as many numbers, got ",
          text_of(lower), " and ", text_of(upper));
  for (std::size_t axis = 0; axis < lower.size(); ++axis) {
    require(lower[axis] < upper[axis], "box: lower must be below upper along every axis, got ",
            text_of(lower), " and ", text_of(upper));
  }
}

double HalfSpace::distance(const Vec3& x) const { return gradient(x).dot(x - place(point)); }

Vec3 HalfSpace::gradient(const Vec3&) const { return place(normal).normalized(); }

Bounds HalfSpace::bounds() const {
  Bounds all;
  const Vec3 outward = place(normal);
  for (int axis = 0; axis < 3; ++axis) {
    if (outward.cwiseAbs().sum() == std::abs(outward[axis])) {
      (outward[axis] > 0.0 ? all.upper : all.lower)[axis] = place(point)[axis];
    }
  }
  return all;
}

void HalfSpace::check(int dimension) const {
  const auto most = static_cast<std::size_t>(dimension);
  require_numbers(point, 1, most, kind, "point");
  require_numbers(normal, 1, most, kind, "normal");
  require(place(normal).norm() > 0.0, "half-space: normal must not be zero");
}

}  // namespace lapilli
