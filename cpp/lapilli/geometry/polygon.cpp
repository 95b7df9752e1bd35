#include "lapilli/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapilli/core/interruption.hpp"
#include "lapilli/geometry/checks.hpp"

namespace lapilli {
namespace {

using Vec2 = Vec<2>;

Vec2 vertex(const Polygon& polygon, std::size_t k) {
  const auto& numbers = polygon.vertices[k % polygon.vertices.size()];
  return {numbers[0], numbers[1]};
}

double cross(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }

double signed_area(const Polygon& polygon) {
  double twice = 0.0;
  const Vec2 first = vertex(polygon, 0);
  for (std::size_t k = 1; k + 1 < polygon.vertices.size(); ++k) {
    twice += cross(vertex(polygon, k) - first, vertex(polygon, k + 1) - first);
  }
  return 0.5 * twice;
}

struct Nearest {
  Vec2 offset;  // from the outline to the point
  double squared = std::numeric_limits<double>::infinity();
  std::size_t edge = 0;
  bool inside = false;
};

Nearest nearest(const Polygon& polygon, const Vec2& x) {
  constexpr std::size_t many = 1000;  // whose distance takes longer than to ask
  if (polygon.vertices.size() > many) {
    allow_interruption();
  }
  Nearest best;
  for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
    const Vec2 a = vertex(polygon, k), b = vertex(polygon, k + 1);
    const Vec2 along = b - a;
    const double share = std::clamp((x - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Vec2 offset = x - (a + share * along);
    if (offset.squaredNorm() < best.squared) {
      best.offset = offset;
      best.squared = offset.squaredNorm();
      best.edge = k;
    }
    if ((a[1] > x[1]) != (b[1] > x[1])) {
      const bool upward = b[1] > a[1];
      best.inside ^= (cross(along, x - a) > 0.0) == upward;
    }
  }
  return best;
}

bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  if (((c_side > 0) != (d_side > 0)) && ((a_side > 0) != (b_side > 0)) &&
      !(c_side == 0 && d_side == 0)) {
    return true;
  }
  const auto on_segment = [](const Vec2& from, const Vec2& to, const Vec2& x, double side) {
    return side == 0.0 && (x - from).dot(x - to) <= 0.0;
  };
  return on_segment(a, b, c, c_side) || on_segment(a, b, d, d_side) ||
         on_segment(c, d, a, a_side) || on_segment(c, d, b, b_side);
}

// The outline may only turn back on itself at a vertex shared by neighbours.
bool neighbours_overlap(const Vec2& before, const Vec2& corner, const Vec2& after) {
  const Vec2 in = before - corner, out = after - corner;
  return cross(in, out) == 0.0 && in.dot(out) > 0.0;
}

void require_simple(const Polygon& polygon) {
  const std::size_t count = polygon.vertices.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto left = [&](std::size_t k) {
    return std::min(vertex(polygon, k)[0], vertex(polygon, k + 1)[0]);
  };
  const auto right = [&](std::size_t k) {
    return std::max(vertex(polygon, k)[0], vertex(polygon, k + 1)[0]);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  for (std::size_t i = 0; i < count; ++i) {
    allow_interruption();
    for (std::size_t j = i + 1; j < count && left(order[j]) <= right(order[i]); ++j) {
      const std::size_t e = std::min(order[i], order[j]), f = std::max(order[i], order[j]);
      const Vec2 a = vertex(polygon, e), b = vertex(polygon, e + 1);
      const Vec2 c = vertex(polygon, f), d = vertex(polygon, f + 1);
      const bool follows = f == e + 1, precedes = e == 0 && f == count - 1;
      const bool bad = follows    ? neighbours_overlap(a, b, d)
                       : precedes ? neighbours_overlap(c, d, b)
                                  : segments_meet(a, b, c, d);
      require(!bad, "polygon: the outline crosses or touches itself: edge ", e, " from (", a[0],
              ", ", a[1], ") to (", b[0], ", ", b[1], ") meets edge ", f, " from (", c[0], ", ",
              c[1], ") to (", d[0], ", ", d[1], ")");
    }
  }
}

}  // namespace

double Polygon::distance(const Vec3& x) const {
  const Nearest at = nearest(*this, x.head<2>());
  return at.inside ? -std::sqrt(at.squared) : std::sqrt(at.squared);
}

Vec3 Polygon::gradient(const Vec3& x) const {
  const Nearest at = nearest(*this, x.head<2>());
  Vec3 normal = Vec3::Zero();
  const Vec2 along = vertex(*this, at.edge + 1) - vertex(*this, at.edge);
  if (at.squared > 1e-24 * along.squaredNorm()) {
    normal.head<2>() = (at.inside ? -1.0 : 1.0) * at.offset.normalized();
  } else {
    const double sense = signed_area(*this) > 0.0 ? 1.0 : -1.0;
    normal.head<2>() = sense * Vec2(along[1], -along[0]).normalized();
  }
  return normal;
}

Bounds Polygon::bounds() const {
  Bounds all;
  all.lower.head<2>() = all.upper.head<2>() = vertex(*this, 0);
  for (std::size_t k = 1; k < vertices.size(); ++k) {
    all.lower.head<2>() = all.lower.head<2>().cwiseMin(vertex(*this, k));
    all.upper.head<2>() = all.upper.head<2>().cwiseMax(vertex(*this, k));
  }
  return all;
}

void Polygon::check(int dimension) const {
  require_dimension(dimension, 2, kind, "a box");
  require(vertices.size() >= 3, "polygon: at least 3 vertices are needed, got ", vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    require_row(vertices[k], 2, kind, "vertex", k);
  }
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    require(vertex(*this, k) != vertex(*this, k + 1), "polygon: vertices ", k, " and ",
            (k + 1) % vertices.size(), " are the same point ", text_of(vertices[k]),
            " (the last vertex joins the first by itself)");
  }
  require_simple(*this);
}

}  // namespace lapilli
