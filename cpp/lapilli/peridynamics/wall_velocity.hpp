#pragma once

#include "lapilli/peridynamics/bond_sums.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// Let the viscous sum of a fluid point see walls where their surface is: a wall point at depth d_j
/// shows a fluid point at distance d_i the velocity v_s + (v_s - v_i) d_j/d_i (free slip: of the
/// part along the normal only, and the fluid's own along the surface). `rows` and `bond_weight` are
/// those of `sum_bonds`.
template <int Dim>
void add_wall_velocity(const WallSurface& walls, const Families& families, const double* rows,
                       const double* bond_weight, Index point, BondSums<Dim>& sums);

}  // namespace lapilli
