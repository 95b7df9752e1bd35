#pragma once

#include <vector>

#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/dynamics/obstacles/rigid_motion.hpp"

namespace lapilli {

/// The surface of an obstacle where it is.
struct ObstacleSurface {
  const Shape& shape;
  const RigidMotion& motion;

  double gap(const Vec3& x) const { return distance(shape, motion.reference(x)); }
  /// Of the obstacle, at the place nearest to one.
  Vec3 normal(const Vec3& x) const { return motion.turned(gradient(shape, motion.reference(x))); }
};

/// A face of an obstacle that ends at a sharp edge, seen from a point beside it.
struct FaceEnd {
  Vec3 normal, outwards;  // unit vectors out of the face, and along it towards the edge
  double distance = 0.0;  // m, along it to the edge; below 0 of a point beyond it
};

// `foot` and `normal` are those of a point at `x`; faces as far as `reach` along the surface are
// looked at, edges are sharp where the normal turns by 75 degrees or more.

/// Whether the surface may bend as sharply as at an edge.
bool is_near_edge(const ObstacleSurface& surface, const Vec3& foot, const Vec3& normal,
                  int dimension, double reach);
/// Whether the foot lies on an edge, to a hundredth of `size`.
bool is_on_edge(const ObstacleSurface& surface, const Vec3& foot, const Vec3& normal, int dimension,
                double size);
/// Ends of the face that the foot lies on; of all the faces at its edge for one `on_edge`.
std::vector<FaceEnd> face_ends(const ObstacleSurface& surface, const Vec3& x, const Vec3& foot,
                               const Vec3& normal, int dimension, double reach, bool on_edge);

}  // namespace lapilli
