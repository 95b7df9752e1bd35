#pragma once

#include "lapilli/peridynamics/bond_sums.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// Let the viscous sum of a fluid point see walls where their surface is: a wall point at depth d_j
/// shows a fluid point at distance d_i the velocity v_s + (v_s - v_i) d_j/d_i (free slip: of the
/// part along the normal only, and the fluid's own along the surface). `rows` and `bond_weight` are
/// those of `sum_bonds`.
///
/// A profile that curves leaves that line behind the wall by v'' (d_j^2 + d_i d_j)/2. Where the
/// fluid sticks, v'' along the normal is the Laplacian itself, and `curved` becomes
/// sum w V (d_j^2 + d_i d_j)/2: see `viscous_share`. Not so at a surface that runs while its points
/// stay: the layer below a lid is thinner than the family (Re 100: 5 to 10 % too fast with it).
template <int Dim>
void add_wall_velocity(const WallSurface& walls, const Families& families, const double* rows,
                       const double* bond_weight, Index point, BondSums<Dim>& sums);

/// By what the Laplacian of a fluid point, `per_sum` times its viscous sum, grows with what its
/// profile's curvature adds behind the wall: L = per_sum (S + curved L). Parabolas between walls
/// are exact. At most 1.5, what the nearest points of a lattice have beside a flat wall.
double viscous_share(double per_sum, double curved);

/// Leave the motion of other walls out of the velocity gradient of a wall point: walls that slide
/// along each other neither thin nor press what lies between them. Nor does a surface that runs
/// while its points stay (`stays`): of it only the fluid's own velocity counts. `sums` are those of
/// `sum_bonds`.
template <int Dim>
void leave_out_walls(const Families& families, const double* rows, const double* bond_weight,
                     Index point, bool stays, BondSums<Dim>& sums);

/// Viscous heating of a fluid point, 2 mu e : e with e the symmetric velocity gradient, W/m^3. The
/// gradient sees walls as above, and so keeps linear velocities up to them; `sums` are those of
/// `sum_bonds`, `viscosity` in Pa s.
template <int Dim>
double viscous_heating(const WallSurface& walls, const Families& families, const double* rows,
                       const double* bond_weight, Index point, const BondSums<Dim>& sums,
                       double viscosity);

}  // namespace lapilli
