#pragma once

#include <span>

#include "lapilli/geometry/clip.hpp"

namespace lapilli {

/// A part of a box that lies in a shape.
struct Part {
  double volume = 0.0;           // m^dimension
  Vec3 centroid = Vec3::Zero();  // undefined where the volume is 0
  Mat3 spread = Mat3::Zero();    // int (x - c)(x - c)^T dV about the centroid c
  bool is_whole = false;         // all of the box
};

/// Volume, first and second moments of a part about a fixed origin, added up piece by piece.
struct MomentSum {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();

  void add(double weight, const MomentSum& other) {
    volume += weight * other.volume;
    first += weight * other.first;
    second += weight * other.second;
  }

  /// A place `x` from the origin that stands for `weight`.
  void add_place(double weight, const Vec3& x) {
    volume += weight;
    first += weight * x;
    second += weight * x * x.transpose();
  }

  /// The part they describe, `origin` added to its centroid; empty where the volume is at most
  /// `least`.
  Part part(const Vec3& origin, double least = 0.0) const;
};

/// The whole of a box with one corner in the origin.
MomentSum moments_of_box(double side, int dimension);

/// Of a polygon in the x-y plane about `origin`; clockwise ones count negative.
MomentSum moment_sum(const Outline& polygon, const Vec<2>& origin);

/// Of a convex body about `origin`.
MomentSum moment_sum(const Polyhedron& body, const Vec3& origin);

}  // namespace lapilli
