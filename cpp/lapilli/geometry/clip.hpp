#pragma once

#include <array>
#include <span>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// A straight cut that keeps the places with normal . x <= offset; the normal may have any length
/// but zero.
template <int Dim>
struct Cut {
  Vec<Dim> normal;
  double offset;
};

/// The cut through `point` that keeps the side `normal` points away from.
template <int Dim>
Cut<Dim> cut_through(const Vec<Dim>& point, const Vec<Dim>& normal) {
  return {normal, normal.dot(point)};
}

/// Size (area or volume) and centroid; an empty part has size 0 and an undefined centroid.
template <int Dim>
struct Moments {
  double size = 0.0;  // m^Dim
  Vec<Dim> centroid = Vec<Dim>::Zero();
};

/// A place that stands for `weight` of an area or volume.
template <int Dim>
struct QuadraturePoint {
  Vec<Dim> position;
  double weight;  // m^Dim
};

/// Corners in order, counter-clockwise.
using Outline = std::vector<Vec<2>>;

/// The corners of an axis-aligned rectangle.
Outline rectangle(const Vec<2>& lower, const Vec<2>& upper);

/// What the cuts leave of a polygon; empty if nothing. A polygon that is not convex may be left in
/// parts joined along the cuts by doubled edges, which carry no area: `moments` stay exact. The
/// cuts together always keep a convex region (Sutherland and Hodgman 1974).
Outline clip_polygon(Outline polygon, std::span<const Cut<2>> cuts);

/// Area and centroid, exact to rounding; clockwise outlines have negative areas.
Moments<2> moments(const Outline& polygon);

/// Points and weights that integrate quadratic functions exactly over a convex polygon: three in
/// each triangle of a fan.
std::vector<QuadraturePoint<2>> quadrature(const Outline& polygon);

/// A convex body as its faces: corners in order, counter-clockwise seen from outside.
struct Polyhedron {
  std::vector<std::vector<Vec3>> faces;

  bool empty() const { return faces.empty(); }
};

using Tetrahedron = std::array<Vec3, 4>;

/// An axis-aligned box.
Polyhedron cuboid(const Vec3& lower, const Vec3& upper);

/// What the cuts leave of a convex body; empty if nothing.
Polyhedron clip_polyhedron(Polyhedron body, std::span<const Cut<3>> cuts);

/// Tetrahedra of positive volume that fill a convex body, from a point inside to its faces.
std::vector<Tetrahedron> tetrahedra(const Polyhedron& body);

double volume(const Tetrahedron& corners);

/// Volume and centroid, exact to rounding.
Moments<3> moments(const Polyhedron& body);

/// Points and weights that integrate quadratic functions exactly: four in each tetrahedron.
std::vector<QuadraturePoint<3>> quadrature(std::span<const Tetrahedron> parts);

}  // namespace lapilli
