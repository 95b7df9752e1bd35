#include "lapilli/mpm/dynamics/obstacles/obstacle_surface.hpp"

#include <algorithm>

namespace lapilli {
namespace {

constexpr double sharp = 0.26;         // cosine of the turn of the normal at an edge
constexpr double off_the_face = 1e-3;  // of the reach
constexpr double close = 0.05;         // of the size, how far beside a foot its edge is looked for

/// Unit vectors along a surface, each followed by its opposite.
std::vector<Vec3> ways_along(const Vec3& normal, int dimension, bool diagonal = false) {
  std::vector<Vec3> ways;
  const auto add = [&](const Vec3& way) {
    ways.push_back(way.normalized());
    ways.push_back(-ways.back());
  };
  if (dimension == 2) {
    add(Vec3(-normal[1], normal[0], 0.0));
    return ways;
  }
  int least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Vec3 first = normal.cross(Vec3(Vec3::Unit(least))).normalized();
  const Vec3 second = normal.cross(first);
  add(first);
  add(second);
  if (diagonal) {
    add(first + second);
    add(first - second);
  }
  return ways;
}

/// The faces that meet at the edge below a point.
std::vector<FaceEnd> faces_at_edge(const ObstacleSurface& surface, const Vec3& x, const Vec3& foot,
                                   const Vec3& normal, int dimension, double size) {
  std::vector<FaceEnd> ends;
  for (const Vec3& way : ways_along(normal, dimension, true)) {
    const Vec3 face = surface.normal(foot + close * size * way);
    const Vec3 beside = x - foot - (x - foot).dot(face) * face;
    const double offset = beside.norm();
    const bool known = std::ranges::any_of(
        ends, [&](const FaceEnd& end) { return end.normal.dot(face) > 1.0 - sharp; });
    if (!known && offset > 0.0 && face.dot(normal) < 1.0 - 1e-6) {
      ends.push_back({face, beside / offset, -offset});
    }
  }
  return ends;
}

}  // namespace

bool is_near_edge(const ObstacleSurface& surface, const Vec3& foot, const Vec3& normal,
                  int dimension, double reach) {
  constexpr double bent = 0.75;  // at an edge, normals lie between those of the faces
  return std::ranges::any_of(ways_along(normal, dimension), [&](const Vec3& way) {
    const Vec3 at = foot + reach * way;
    return surface.gap(at) > off_the_face * reach && surface.normal(at).dot(normal) < bent;
  });
}

bool is_on_edge(const ObstacleSurface& surface, const Vec3& foot, const Vec3& normal, int dimension,
                double size) {
  const std::vector<Vec3> ways = ways_along(normal, dimension, true);
  const auto falls = [&](const Vec3& way) {
    return surface.gap(foot + close * size * way) > 0.2 * close * size;
  };
  for (std::size_t k = 0; k < ways.size(); k += 2) {
    if (falls(ways[k]) && falls(ways[k + 1])) {
      return true;
    }
  }
  return false;
}

std::vector<FaceEnd> face_ends(const ObstacleSurface& surface, const Vec3& x, const Vec3& foot,
                               const Vec3& normal, int dimension, double reach, bool on_edge) {
  if (on_edge) {
    return faces_at_edge(surface, x, foot, normal, dimension, 0.5 * reach);
  }
  std::vector<FaceEnd> ends;
  for (const Vec3& way : ways_along(normal, dimension)) {
    const Vec3 at = foot + reach * way;
    const double gap = surface.gap(at);
    const Vec3 out = surface.normal(at);
    // In the plane of the face, what is nearest to a place beyond its end is the edge.
    if (gap > off_the_face * reach && out.dot(normal) < sharp) {
      const Vec3 along = (out - out.dot(normal) * normal).normalized();
      ends.push_back({normal, along, reach * along.dot(way) - gap});
    }
  }
  return ends;
}

}  // namespace lapilli
