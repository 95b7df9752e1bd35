#pragma once

#include <array>

#include "lapilli/geometry/fill.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The frame in which the particles of a peridynamic fluid start: it is turned and moved as the
/// shape of the first body is, its lattice lies in the middle of that shape, and its spacing is the
/// one near the grid's of which the sides of the shape are multiples. So a fluid starts the same
/// wherever in the grid and at whatever angle it lies, half a spacing from flat faces. The frame of
/// the grid where nothing flows.
class FluidFrame {
 public:
  FluidFrame(const Scene& scene, int points_per_axis);

  /// A shape of the scene filled in this frame, points at their places in the scene.
  FilledPoints fill(const Shape& shape, FillOptions options, int dimension) const;

  /// The box of the lattice in which a place of the scene lies.
  std::array<long, 3> site(const Vec3& at) const;

 private:
  void follow(const Shape& shape);
  void fit_lattice(const Shape& shape, int dimension);
  Shape seen_from_here(const Shape& shape, int dimension) const;
  Bounds seen_from_here(const Bounds& box, int dimension) const;
  Vec3 here(const Vec3& at) const { return turn_.transpose() * (at - origin_); }

  Mat3 turn_ = Mat3::Identity();  // from this frame to the scene
  Vec3 origin_ = Vec3::Zero();    // m, of this frame in the scene
  Lattice lattice_;
};

}  // namespace lapilli
