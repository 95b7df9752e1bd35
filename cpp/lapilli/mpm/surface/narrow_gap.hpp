#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lapilli/geometry/grid.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// Empty space between two surfaces that face each other.
struct NarrowGap {
  double width;  // m
  Vec3 middle;   // m

  /// "a gap of 0.06 m at (0.5, 0.567) m is bridged: ...", with so many axes.
  std::string in_words(int axes) const;
};

/// The narrowest gap between surfaces of `shapes`, of two bodies or of one, whose sides lie in
/// cells that share a node: fields of nodes bridge it. Looks in the cells marked in `cells`. Bodies
/// that touch (nearer than a twentieth of a cell) leave none, nor do notches wider than 16 degrees.
/// `shapes` must have been checked.
template <int Dim>
std::optional<NarrowGap> narrowest_gap(const Grid<Dim>& grid, std::span<const char> cells,
                                       const std::vector<Shape>& shapes);

}  // namespace lapilli
