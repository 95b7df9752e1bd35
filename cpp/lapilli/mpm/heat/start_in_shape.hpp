#pragma once

#include <span>
#include <vector>

#include "lapilli/core/value.hpp"
#include "lapilli/geometry/grid.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// The places of nodes, those outside of a checked shape moved to its surface.
template <int Dim>
std::vector<Vec3> places_in_shape(const Shape& shape, const Grid<Dim>& grid,
                                  std::span<const Index> nodes);

/// A temperature at the start, at the nodes of body number `body`: functions are asked inside the
/// shape only, and go on from there in a straight line where the nodes lie outside. Throws
/// std::invalid_argument when a value is not finite.
template <int Dim>
std::vector<double> start_at_nodes(const Value& temperature, const Shape& shape,
                                   const Grid<Dim>& grid, std::span<const Index> nodes,
                                   std::size_t body);

}  // namespace lapilli
