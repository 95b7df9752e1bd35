#pragma once

#include <span>
#include <vector>

#include "lapilli/geometry/clip.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// Volume, first and second moments of a part of space about a point.
struct SecondMoments {
  Vec3 about = Vec3::Zero();   // m
  double volume = 0.0;         // m^3
  Vec3 first = Vec3::Zero();   // m^4
  Mat3 second = Mat3::Zero();  // m^5

  void add(const Tetrahedron& part);
  /// Adds a part known about the same point.
  void add(const SecondMoments& part, double share = 1.0);
};

/// Tetrahedra that fill the part of the box [low, low + size] in a convex shape with flat faces.
std::vector<Tetrahedron> parts_of_box(std::span<const Cut<3>> cuts, const Vec3& low, double size);

/// Tetrahedra that fill the part of the box in any shape: `halves` boxes along each axis, each in
/// six tetrahedra cut along the linear interpolant of the distance.
std::vector<Tetrahedron> parts_of_box(const Shape& shape, const Vec3& low, double size, int halves);

/// The moments of the part of the box in any shape, about its middle: those of two and of four
/// boxes along each axis, extrapolated.
SecondMoments moments_of_box(const Shape& shape, const Vec3& low, double size);

}  // namespace lapilli
