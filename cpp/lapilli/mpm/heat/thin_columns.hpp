#pragma once

#include <vector>

#include "lapilli/mpm/heat/point_fields.hpp"
#include "lapilli/mpm/surface/surface_foot.hpp"

namespace lapilli {

/// By foot, how far the body ends on the other side within reach of the nodes around it, from 0
/// (2.75 cells away, or more) to 1 (2.4 cells, or less): there area vectors are those of both
/// sides. `capacity` is by node of the grid.
template <int Dim>
std::vector<double> thin_columns(const Grid<Dim>& grid, const Points& points,
                                 const std::vector<SurfaceFoot<Dim>>& feet,
                                 const HeatCoefficients<Dim>& coefficients,
                                 const std::vector<double>& capacity);

}  // namespace lapilli
