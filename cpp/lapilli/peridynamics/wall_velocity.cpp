#include "lapilli/peridynamics/wall_velocity.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace lapilli {

namespace {

/// Call body(bond, w V, more) for the bonds of `point` to walls: `more` is what the wall's
/// velocity, continued behind its surface, adds to v_j - v_i.
template <int Dim, class Body>
void for_wall_bonds(const WallSurface& walls, const Families& families, const double* rows,
                    const double* bond_weight, Index point, const Body& body) {
  const double* own = rows + point * flow_row_size;
  const double least = 0.25 * walls.spacing();
  for (Index k = families.wall_begin(point); k < families.end(point); ++k) {
    const double w = bond_weight[k - families.begin(point)];
    if (w == 0.0) {
      continue;
    }
    const Index j = families.neighbour(k);
    const double* other = rows + j * flow_row_size;
    const double ahead = std::max(least, walls.template distance<Dim>(own, j));
    const double ratio = walls.depth(j) / ahead;
    Vec<Dim> bond, relative;
    for (int d = 0; d < Dim; ++d) {
      bond[d] = other[d] - own[d];
      relative[d] = other[4 + d] - own[4 + d];
    }
    Vec<Dim> more = ratio * relative;
    if (walls.walls()[walls.wall(j)].settings.slip == Slip::free_slip) {
      const Eigen::Map<const Vec<Dim>> n(walls.normal(j));
      more = (1.0 + ratio) * n.dot(relative) * n - relative;
    }
    body(bond, w, more);
  }
}

}  // namespace

template <int Dim>
void add_wall_velocity(const WallSurface& walls, const Families& families, const double* rows,
                       const double* bond_weight, Index point, BondSums<Dim>& sums) {
  for_wall_bonds<Dim>(
      walls, families, rows, bond_weight, point,
      [&](const Vec<Dim>&, double w, const Vec<Dim>& more) { sums.velocity += w * more; });
}

template <int Dim>
void leave_out_walls(const Families& families, const double* rows, const double* bond_weight,
                     Index point, bool stays, BondSums<Dim>& sums) {
  const double* own = rows + point * flow_row_size;
  sums.gradient.setZero();
  for (Index k = families.begin(point); k < families.wall_begin(point); ++k) {
    const double* other = rows + families.neighbour(k) * flow_row_size;
    Vec<Dim> bond, relative;
    for (int d = 0; d < Dim; ++d) {
      bond[d] = other[d] - own[d];
      relative[d] = other[4 + d] - (stays ? 0.0 : own[4 + d]);
    }
    sums.gradient += bond_weight[k - families.begin(point)] * relative * bond.transpose();
  }
}

template <int Dim>
double viscous_heating(const WallSurface& walls, const Families& families, const double* rows,
                       const double* bond_weight, Index point, const BondSums<Dim>& sums,
                       double viscosity) {
  Mat<Dim> slope = sums.gradient;
  for_wall_bonds<Dim>(walls, families, rows, bond_weight, point,
                      [&](const Vec<Dim>& bond, double w, const Vec<Dim>& more) {
                        slope += w * more * bond.transpose();
                      });
  const Mat<Dim> gradient = slope * sums.shape.inverse();
  return 0.5 * viscosity * (gradient + gradient.transpose()).squaredNorm();
}

#define LAPILLI_INSTANTIATE(Dim)                                                                 \
  template void add_wall_velocity<Dim>(const WallSurface&, const Families&, const double*,       \
                                       const double*, Index, BondSums<Dim>&);                    \
  template void leave_out_walls<Dim>(const Families&, const double*, const double*, Index, bool, \
                                     BondSums<Dim>&);                                            \
  template double viscous_heating<Dim>(const WallSurface&, const Families&, const double*,       \
                                       const double*, Index, const BondSums<Dim>&, double);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
