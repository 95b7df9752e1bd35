#include "lapilli/geometry/support.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {
namespace {

// How far a shape reaches along a direction: the most of direction . x over its places x.
struct Reach {
  double most;
  bool is_tight = true;
};

Reach reach(const Shape& shape, const Vec3& direction);

Reach of_box(const Vec3& lower, const Vec3& upper, const Vec3& direction) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] != 0.0) {  // times infinity
      sum += direction[axis] * (direction[axis] > 0.0 ? upper : lower)[axis];
    }
  }
  return {sum};
}

Reach of_circle(const std::vector<double>& center, double radius, const Vec3& direction) {
  const Vec<2> flat = direction.head<2>();
  const bool along_z = std::abs(direction[2]) > 0.0;
  return {along_z ? std::numeric_limits<double>::infinity()
                  : flat.dot(place(center).head<2>()) + radius * flat.norm()};
}

Reach of_kind(const Box& box, const Vec3& direction) {
  const Bounds own = box.bounds();
  return of_box(own.lower, own.upper, direction);
}
Reach of_kind(const Disk& disk, const Vec3& direction) {
  return of_circle(disk.center, disk.radius, direction);
}
Reach of_kind(const Annulus& ring, const Vec3& direction) {
  return of_circle(ring.center, ring.outer, direction);
}
Reach of_kind(const Sphere& ball, const Vec3& direction) {
  return {direction.dot(place(ball.center)) + ball.radius * direction.norm()};
}
Reach of_kind(const Cylinder& rod, const Vec3& direction) {
  const Vec3 axis = (place(rod.end) - place(rod.start)).normalized();
  const double across = (direction - direction.dot(axis) * axis).norm();
  return {std::max(direction.dot(place(rod.start)), direction.dot(place(rod.end))) +
          rod.radius * across};
}
Reach of_kind(const Polygon& polygon, const Vec3& direction) {
  if (direction[2] != 0.0) {
    return {std::numeric_limits<double>::infinity()};
  }
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& vertex : polygon.vertices) {
    most = std::max(most, direction.dot(place(vertex)));
  }
  return {most};
}
Reach of_kind(const Mesh& mesh, const Vec3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& vertex : mesh.surface->triangles().vertices) {
    most = std::max(most, direction.dot(vertex));
  }
  return {most};
}
Reach of_kind(const Ellipse& ellipse, const Vec3& direction) {
  if (direction[2] != 0.0) {
    return {std::numeric_limits<double>::infinity()};
  }
  return {direction.dot(place(ellipse.center)) +
          direction.cwiseProduct(place(ellipse.semi_axes)).norm()};
}
Reach of_kind(const Ellipsoid& ellipsoid, const Vec3& direction) {
  return {direction.dot(place(ellipsoid.center)) +
          direction.cwiseProduct(place(ellipsoid.semi_axes)).norm()};
}
Reach of_kind(const HeightField& ground, const Vec3& direction) {
  return ground.mesh ? of_kind(*ground.mesh, direction) : of_kind(*ground.profile, direction);
}
Reach of_kind(const Union& all, const Vec3& direction) {
  Reach most{-std::numeric_limits<double>::infinity()};
  for (const Shape& shape : all.shapes) {
    const Reach one = reach(shape, direction);
    most = {std::max(most.most, one.most), most.is_tight && one.is_tight};
  }
  return most;
}
Reach of_kind(const Rotated& rotated, const Vec3& direction) {
  const Vec3 center = place(rotated.center), before = rotated.matrix().transpose() * direction;
  Reach inner = reach(*rotated.shape, before);
  inner.most += direction.dot(center) - before.dot(center);
  return inner;
}
Reach of_kind(const Translated& moved, const Vec3& direction) {
  Reach inner = reach(*moved.shape, direction);
  inner.most += direction.dot(place(moved.by));
  return inner;
}
// Half-spaces, images, intersections and differences: by their bounds.
template <class Other>
Reach of_kind(const Other& shape, const Vec3& direction) {
  const Bounds own = shape.bounds();
  return {of_box(own.lower, own.upper, direction).most, false};
}

Reach reach(const Shape& shape, const Vec3& direction) {
  using Variant = Shape::variant;
  return std::visit([&](const auto& one) { return of_kind(one, direction); },
                    static_cast<const Variant&>(shape));
}

}  // namespace

TightBounds tight_bounds(const Shape& shape) {
  TightBounds all;
  all.is_tight = true;
  for (int axis = 0; axis < 3; ++axis) {
    const Reach above = reach(shape, Vec3::Unit(axis)), below = reach(shape, -Vec3::Unit(axis));
    all.box.upper[axis] = above.most;
    all.box.lower[axis] = 0.0 - below.most;  // no negative zero in messages
    all.is_tight &= above.is_tight && below.is_tight;
  }
  return all;
}

}  // namespace lapilli
