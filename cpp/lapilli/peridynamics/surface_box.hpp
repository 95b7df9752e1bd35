#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Corners of a flat polygon in order, m.
using Face = std::vector<Vec3>;

/// Keeps the places with normal . x <= offset.
struct Plane {
  Vec3 normal;
  double offset;

  double operator()(const Vec3& x) const { return normal.dot(x) - offset; }
  Plane turned() const { return {-normal, -offset}; }
};

/// The distance in a box: the largest of its planes, or the smallest.
struct Facets {
  std::vector<Plane> planes;
  bool convex = true;

  double operator()(const Vec3& x) const {
    double value = planes.front()(x);
    for (const Plane& plane : planes) {
      value = convex ? std::max(value, plane(x)) : std::min(value, plane(x));
    }
    return value;
  }
};

/// The surface of a region, a signed distance, in one box; axes past the dimension extend it by its
/// side, half to either side of 0. The distance must outlive it.
class SurfaceBox {
 public:
  SurfaceBox(const std::function<double(const Vec3&)>& region, const Vec3& lower, double side,
             int dimension);

  /// Whether the surface may pass; the functions below are for boxes where it may.
  bool holds_surface() const {
    return std::abs(region_(middle_)) <= 0.5001 * side_ * std::sqrt(double(dimension_));
  }
  /// Look at the distance in some places, once before the four functions below.
  void sample();
  /// Whether some of these places are inside and some outside.
  bool both_sides() const;
  /// Planes that stand for the distance to `slack` of the box; none if it cannot be told by few.
  std::optional<Facets> facets(double slack) const;
  /// The same by the plane in the middle alone.
  std::optional<Facets> plane(double slack) const;
  /// The plane in the middle, where nothing better is known; none where it has no slope.
  std::optional<Facets> rough() const;

  /// What of plane `which` lies in the box and on the surface.
  Face face(const Facets& facets, std::size_t which) const;
  /// The surface as polygons through the places where it crosses the edges of simplices that fill
  /// the box: without gaps from box to box.
  std::vector<Face> curved_faces() const;

  /// The normal of a face, turned out of the region.
  Vec3 outward(const Vec3& at, const Vec3& normal) const;
  /// Area of a face without the extent that missing axes gave it, m^(dimension - 1).
  double area(double extended) const { return extended / std::pow(side_, 3 - dimension_); }

 private:
  struct Sample {
    Vec3 place;
    double value;
    bool sheer;  // the slope is that of a plane, not of a kink
    Plane plane;
  };

  Vec3 slope_at(const Vec3& at) const;
  Sample sample_at(const Vec3& at) const;
  /// The planes that the near side of an edge or corner shows, if they tell where the surface is.
  std::optional<Facets> edge(bool convex, double slack_share) const;
  bool straight(const Sample& one, double slack_share) const;
  Vec3 crossing(Vec3 inside, Vec3 outside) const;
  void add_simplex(const std::vector<Vec3>& corners, std::vector<Face>& faces) const;

  const std::function<double(const Vec3&)>& region_;
  Vec3 lower_, middle_;
  double side_;
  int dimension_;
  std::vector<Sample> samples_;
};

}  // namespace lapilli
