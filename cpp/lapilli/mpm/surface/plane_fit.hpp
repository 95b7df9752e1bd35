#pragma once

#include <vector>

#include "lapilli/geometry/clip.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/surface/level_set.hpp"

namespace lapilli {

/// A cube of the grid or a part of one.
template <int Dim>
struct Cube {
  Vec<Dim> low;
  double side;

  Vec<Dim> middle() const { return low + Vec<Dim>::Constant(0.5 * side); }
  /// One of its 2^Dim corners.
  Vec<Dim> corner(int which) const {
    Vec<Dim> place = low;
    for (int axis = 0; axis < Dim; ++axis) {
      place[axis] += ((which >> axis) & 1) * side;
    }
    return place;
  }
  /// One of the 2^Dim parts of half the side.
  Cube part(int which) const {
    const Cube half{low, 0.5 * side};
    return {half.corner(which), half.side};
  }
};

/// A shape as seen from inside a cube: what lies behind all of its planes, or behind any of them (a
/// reflex edge). Normals have length 1 and point out of the shape.
template <int Dim>
struct PlaneFit {
  enum class Join { all, any };
  /// `full`, `empty`: no surface inside; `cut`: the planes tell the shape to the tolerance asked
  /// for; `rough`: they do not.
  enum class State { full, empty, cut, rough };

  State state = State::empty;
  Join join = Join::all;
  std::vector<Cut<Dim>> planes;
};

/// Fit planes to a checked shape in a cube: flat faces, edges and corners where all faces bend one
/// way are exact; curved faces within `tolerance` (m), in two dimensions as chords that join those
/// of the neighbours. With `settle` a rough fit parts the corners of the cube as the shape does.
template <int Dim>
PlaneFit<Dim> fit_planes(const Shape& shape, const Cube<Dim>& cube, double tolerance, bool settle);

/// The same of what lies where a distance is negative.
template <int Dim>
PlaneFit<Dim> fit_planes(const LevelSet& surface, const Cube<Dim>& cube, double tolerance,
                         bool settle);

}  // namespace lapilli
