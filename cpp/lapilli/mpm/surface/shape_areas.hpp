#pragma once

#include <span>
#include <vector>

#include "lapilli/geometry/grid.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/surface/wall_contact.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {

/// The free surface of bodies of known shape, m^(Dim-1); what rests on another body or a wall of
/// the grid is none.
struct ShapeAreas {
  std::vector<double> whole;                       // by body
  std::vector<std::vector<double>> by_condition;   // by body and boundary condition
  std::vector<std::vector<std::size_t>> touching;  // by body: bodies found to touch it

  std::size_t conditions() const { return by_condition.empty() ? 0 : by_condition.front().size(); }
};

/// `regions` by boundary condition, null for what is left.
template <int Dim>
ShapeAreas areas_of_shapes(const Grid<Dim>& grid, ShapeFunction function,
                           std::span<const Shape> bodies, const std::vector<const Shape*>& regions,
                           const ContactFaces& walls);

/// Bodies that hang together by touching, in groups.
std::vector<std::vector<std::size_t>> groups_of(
    const std::vector<std::vector<std::size_t>>& touching);

}  // namespace lapilli
