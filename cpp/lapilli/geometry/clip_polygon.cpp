#include <cmath>

#include "lapilli/geometry/clip.hpp"

namespace lapilli {
namespace {

double cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

Outline clip_once(const Outline& polygon, const Cut<2>& cut) {
  Outline kept;
  kept.reserve(polygon.size() + 1);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>& here = polygon[k];
    const Vec<2>& next = polygon[(k + 1) % polygon.size()];
    const double beyond = cut.normal.dot(here) - cut.offset;
    const double next_beyond = cut.normal.dot(next) - cut.offset;
    if (beyond <= 0.0) {
      kept.push_back(here);
    }
    // From the kept end, so that slivers keep their digits.
    if (beyond < 0.0 && next_beyond > 0.0) {
      kept.push_back(here + beyond / (beyond - next_beyond) * (next - here));
    } else if (beyond > 0.0 && next_beyond < 0.0) {
      kept.push_back(next + next_beyond / (next_beyond - beyond) * (here - next));
    }
  }
  return kept.size() < 3 ? Outline{} : kept;
}

}  // namespace

Outline rectangle(const Vec<2>& lower, const Vec<2>& upper) {
  return {lower, {upper[0], lower[1]}, upper, {lower[0], upper[1]}};
}

Outline clip_polygon(Outline polygon, std::span<const Cut<2>> cuts) {
  for (const Cut<2>& cut : cuts) {
    polygon = clip_once(polygon, cut);
  }
  return polygon;
}

Moments<2> moments(const Outline& polygon) {
  Moments<2> all;
  if (polygon.size() < 3) {
    return all;
  }
  // Relative to a corner, so that far from the origin no digits are lost.
  const Vec<2> corner = polygon.front();
  Vec<2> moment = Vec<2>::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec<2> a = polygon[k] - corner, b = polygon[k + 1] - corner;
    const double area = 0.5 * cross(a, b);
    all.size += area;
    moment += area / 3.0 * (a + b);
  }
  all.centroid = all.size != 0.0 ? Vec<2>(corner + moment / all.size) : corner;
  return all;
}

std::vector<QuadraturePoint<2>> quadrature(const Outline& polygon) {
  std::vector<QuadraturePoint<2>> points;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec<2>&a = polygon.front(), &b = polygon[k], &c = polygon[k + 1];
    const double area = 0.5 * cross(b - a, c - a);
    if (area > 0.0) {
      const Vec<2> sum = a + b + c;
      for (const Vec<2>* corner : {&a, &b, &c}) {
        points.push_back({(sum + 3.0 * *corner) / 6.0, area / 3.0});
      }
    }
  }
  return points;
}

}  // namespace lapilli
