#pragma once

#include <vector>

#include "lapilli/geometry/grid.hpp"
#include "lapilli/mpm/surface/cube_parts.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {

/// The cubes in which the shape functions of a scene are polynomials: those of one node fill the
/// cell from `shift` cells below it, `per_axis` along each axis.
struct CubeLayout {
  double shift;
  int per_axis;

  explicit CubeLayout(ShapeFunction shape);
};

/// Half-width in cells of the GIMP functions where the points carry nothing but output.
inline constexpr double resting_half_width = 0.25;

/// What the cell of one node has of a shape.
template <int Dim>
struct CellCut {
  typename Grid<Dim>::Cell node;
  unsigned full = 0;                         // one bit a cube that lies inside, first axis fastest
  std::vector<QuadraturePoint<Dim>> points;  // of the volume in the other cubes, m
  std::vector<SurfacePiece<Dim>> pieces;     // of the surface
};

/// The cells of a checked shape, first axis fastest, cut at its surface. Flat faces, their edges
/// and corners are exact; curved faces within 0.1 % of a cell, in three dimensions within 2 % about
/// their mean. What lies beyond the grid is left out. Cuts of many sheets within a sixteenth of a
/// cell (an eighth in three dimensions) are rough.
template <int Dim>
std::vector<CellCut<Dim>> cut_shape(const Shape& shape, const Grid<Dim>& grid,
                                    const CubeLayout& layout);

/// The cube number `which` of the cell of a node.
template <int Dim>
Cube<Dim> cube_of(const Grid<Dim>& grid, const CubeLayout& layout,
                  const typename Grid<Dim>::Cell& node, int which);

}  // namespace lapilli
