#include "lapilli/mpm/dynamics/obstacles/rigid_mass.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/box_parts.hpp"
#include "lapilli/geometry/lattice.hpp"

namespace lapilli {
namespace {

/// Volume, centroid and spread of the shape, from boxes of a lattice across it.
Part whole_of(const Shape& shape, int dimension) {
  const Bounds box = bounds(shape);
  double longest = 0.0;
  for (int axis = 0; axis < dimension; ++axis) {
    longest = std::max(longest, box.upper[axis] - box.lower[axis]);
  }
  const double boxes = dimension == 2 ? 64.0 : 32.0;
  Lattice lattice{Vec3::Zero(), longest / boxes, 1};
  lattice.lower.head(dimension) = box.lower.head(dimension);
  FillOptions options;
  options.clip = true;
  const Shape body = ready_to_fill(shape, lattice, options, dimension);
  const Sites sites(body, lattice, options, dimension);
  MomentSum sum;
  for (const BoxPart& box_part : parts_of(body, sites)) {
    sum.add_place(box_part.part.volume, box_part.part.centroid - lattice.lower);
    sum.second += box_part.part.spread;
  }
  return sum.part(lattice.lower);
}

bool is_bounded(const Shape& shape, int dimension) {
  const Bounds box = bounds(shape);
  return box.lower.head(dimension).allFinite() && box.upper.head(dimension).allFinite();
}

}  // namespace

RigidMass rigid_mass(const Obstacle& obstacle, int dimension, const std::string& where) {
  const int turns = dimension == 2 ? 1 : 3;
  RigidMass found;
  found.mass = *obstacle.mass;
  const bool is_said = !obstacle.center.empty() && !obstacle.inertia.empty();
  require(is_said || is_bounded(obstacle.shape, dimension), where,
          ": a shape without an end needs center and inertia besides its mass");
  Part whole;
  if (!is_said) {
    whole = whole_of(obstacle.shape, dimension);
    require(whole.volume > 0.0, where, ".shape is empty");
  }
  found.center = obstacle.center.empty() ? whole.centroid : place(obstacle.center);
  if (obstacle.inertia.empty()) {
    // About a given centre elsewhere: Steiner.
    const Vec3 arm = found.center - whole.centroid;
    const Mat3 spread = whole.spread / whole.volume + arm * arm.transpose();
    found.inertia = found.mass * (spread.trace() * Mat3::Identity() - spread);
  } else {
    for (int k = 0; k < turns; ++k) {
      const int axis = dimension == 2 ? 2 : k;
      found.inertia(axis, axis) = obstacle.inertia[static_cast<std::size_t>(k)];
    }
  }
  if (dimension == 2) {
    const double about_z = found.inertia(2, 2);
    found.inertia.setZero();
    found.inertia(2, 2) = about_z;
  }
  return found;
}

}  // namespace lapilli
