#include "lapilli/mpm/dynamics/overburden.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

/// The span of a ray within a box; empty (begin > end) where it misses it.
struct Span {
  double begin, end;
};

Span within(const Bounds& box, const Vec3& from, const Vec3& direction) {
  Span span{0.0, std::numeric_limits<double>::infinity()};
  for (int axis = 0; axis < 3; ++axis) {
    double near = (box.lower[axis] - from[axis]) / direction[axis];
    double far = (box.upper[axis] - from[axis]) / direction[axis];
    if (direction[axis] == 0.0) {
      const bool inside = from[axis] >= box.lower[axis] && from[axis] <= box.upper[axis];
      near = inside ? -std::numeric_limits<double>::infinity() : span.end;
      far = inside ? span.end : -std::numeric_limits<double>::infinity();
    }
    span.begin = std::max(span.begin, std::min(near, far));
    span.end = std::min(span.end, std::max(near, far));
  }
  return span;
}

}  // namespace

double length_inside(const Shape& shape, const Vec3& from, const Vec3& direction,
                     const Bounds& room) {
  const Bounds own = bounds(shape);
  const Bounds box{own.lower.cwiseMax(room.lower), own.upper.cwiseMin(room.upper)};
  const Span span = within(box, from, direction);
  if (!(span.begin < span.end)) {
    return 0.0;
  }
  // A signed distance changes by at most the way walked: a step as long as it crosses nothing.
  const double least = 1e-4 * (span.end - span.begin);
  const auto distance_at = [&](double way) { return distance(shape, from + way * direction); };
  double way = span.begin, apart = distance_at(way), entered = way, sum = 0.0;
  bool inside = apart < 0.0;
  while (way < span.end) {
    const double next = std::min(way + std::max(std::abs(apart), least), span.end);
    apart = distance_at(next);
    if ((apart < 0.0) != inside) {
      double low = way, high = next;
      for (int round = 0; round < 60; ++round) {
        const double middle = 0.5 * (low + high);
        ((distance_at(middle) < 0.0) == inside ? low : high) = middle;
      }
      sum += inside ? high - entered : 0.0;
      entered = high;
      inside = !inside;
    }
    way = next;
  }
  return inside ? sum + span.end - entered : sum;
}

Overburden::Overburden(std::vector<Layer> layers, const Vec3& gravity, const Bounds& room)
    : layers_(std::move(layers)), gravity_(gravity.norm()), room_(room) {
  require(gravity_ > 0.0, "geostatic needs gravity, or a surface and a normal");
  up_ = -gravity / gravity_;
}

double Overburden::at(const Vec3& place) const {
  double sum = 0.0;
  for (const Layer& layer : layers_) {
    sum += layer.density * length_inside(layer.shape, place, up_, room_);
  }
  return gravity_ * sum;
}

}  // namespace lapilli
