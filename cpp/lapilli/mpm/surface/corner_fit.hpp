#pragma once

#include "lapilli/mpm/surface/nodal_surface.hpp"

namespace lapilli {

/// Where the surface turns sharply, replace A_I = n_I . a_I by A_I = w_I . a_I: a unit normal gives
/// a 90-degree corner 1/sqrt 2 of its length, a vector w with w . n = 1 for each face gives all of
/// it. w is fitted to the area vectors of the neighbours (weighted least squares, three sweeps); a
/// ramp over the turning angle and a guard against tight curves leave smooth surfaces as they are.
template <int Dim>
void fit_corners(const Grid<Dim>& grid, const NodalSums<Dim>& sums, NodalAreas<Dim>& areas);

}  // namespace lapilli
