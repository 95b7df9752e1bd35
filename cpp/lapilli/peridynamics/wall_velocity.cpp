#include "lapilli/peridynamics/wall_velocity.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace lapilli {

namespace {

/// Call body(bond, w V, more, curved) for the bonds of `point` to walls: `more` is what the wall's
/// velocity, continued behind its surface, adds to v_j - v_i, and `curved` (m^2) times the
/// curvature of the profile what a line leaves out, 0 where the fluid slides or the surface runs.
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
    const FluidWallSettings& wall = walls.walls()[walls.wall(j)].settings;
    const bool slides = wall.slip == Slip::free_slip;
    if (slides) {
      const Eigen::Map<const Vec<Dim>> n(walls.normal(j));
      more = (1.0 + ratio) * n.dot(relative) * n - relative;
    }
    const bool runs = !wall.moves && !Eigen::Map<const Vec<Dim>>(other + 4).isZero(0.0);
    const double curved = slides || runs ? 0.0 : 0.5 * walls.depth(j) * (walls.depth(j) + ahead);
    body(bond, w, more, curved);
  }
}

}  // namespace

template <int Dim>
void add_wall_velocity(const WallSurface& walls, const Families& families, const double* rows,
                       const double* bond_weight, Index point, BondSums<Dim>& sums) {
  for_wall_bonds<Dim>(walls, families, rows, bond_weight, point,
                      [&](const Vec<Dim>&, double w, const Vec<Dim>& more, double curved) {
                        sums.velocity += w * more;
                        sums.curved += w * curved;
                      });
}

double viscous_share(double per_sum, double curved) {
  return 1.0 / (1.0 - std::min(1.0 / 3.0, per_sum * curved));
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
                      [&](const Vec<Dim>& bond, double w, const Vec<Dim>& more, double) {
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
