#pragma once

#include "lapilli/core/vector.hpp"
#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/influence.hpp"

namespace lapilli {

/// Doubles of one point's row in the flow's first pass: x y z V | u v w rho.
inline constexpr Index flow_row_size = 8;

/// What the bonds of one point add up to.
template <int Dim>
struct BondSums {
  Mat<Dim> shape = Mat<Dim>::Zero();     // sum w Y Y V
  Mat<Dim> gradient = Mat<Dim>::Zero();  // sum w (v_j - v_i) Y V
  Vec<Dim> bond = Vec<Dim>::Zero();      // sum w Y V
  Vec<Dim> velocity = Vec<Dim>::Zero();  // sum w (v_j - v_i) V
  double density = 0.0;                  // sum w (rho_j - rho_i) V
  double curved = 0.0;                   // m^2, see `add_wall_velocity`
  Vec<Dim> crowding = Vec<Dim>::Zero();  // sum Y / r^3
  double length = 0.0, count = 0.0;      // sum r, number of bonds within the horizon
  double least_squared = 0.0;            // m^2
};

/// One pass over the family of `point`: everything the flow needs of its neighbours where they are
/// now, four bonds at a time. `weights` receives w V of each bond of the point, for later passes.
template <int Dim>
BondSums<Dim> sum_bonds(const double* rows, const Families& families, const BondWeight& influence,
                        Index point, double* weights);

}  // namespace lapilli
