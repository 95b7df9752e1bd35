#include "lapilli/geometry/shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lapilli {
namespace {

template <class Visitor>
decltype(auto) visit_shape(const Shape& shape, const Visitor& visitor) {
  using Variant = Shape::variant;
  return std::visit(visitor, static_cast<const Variant&>(shape));
}

}  // namespace

double distance(const Shape& shape, const Vec3& x) {
  return visit_shape(shape, [&](const auto& one) { return one.distance(x); });
}

Vec3 gradient(const Shape& shape, const Vec3& x) {
  return visit_shape(shape, [&](const auto& one) { return one.gradient(x); });
}

Vec3 project(const Shape& shape, const Vec3& x) {
  // A distance is no smaller than the rounding of the coordinates it comes from.
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * x.cwiseAbs().maxCoeff();
  Vec3 at = x;
  double left = distance(shape, x);
  const double least = std::max(1e-12 * std::abs(left), rounding);
  for (int step = 0; step < 64 && std::abs(left) > least; ++step) {
    at -= left * gradient(shape, at);
    left = distance(shape, at);
  }
  return at;
}

Bounds bounds(const Shape& shape) {
  return visit_shape(shape, [](const auto& one) { return one.bounds(); });
}

bool covers(const Shape& shape, const Vec3& x, double slack) { return distance(shape, x) <= slack; }

void check(const Shape& shape, int dimension) {
  visit_shape(shape, [&](const auto& one) { one.check(dimension); });
}

const char* kind_of(const Shape& shape) {
  return visit_shape(shape, [](const auto& one) { return one.kind; });
}

}  // namespace lapilli
