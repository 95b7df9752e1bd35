#include "lapilli/peridynamics/wall_velocity.hpp"

#include <algorithm>

namespace lapilli {

template <int Dim>
void add_wall_velocity(const WallSurface& walls, const Families& families, const double* rows,
                       const double* bond_weight, Index point, BondSums<Dim>& sums) {
  const double* own = rows + point * flow_row_size;
  const double least = 0.25 * walls.spacing();
  for (Index k = families.wall_begin(point); k < families.end(point); ++k) {
    const double w = bond_weight[k];
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
    sums.velocity += w * more;
  }
}

template void add_wall_velocity<1>(const WallSurface&, const Families&, const double*,
                                   const double*, Index, BondSums<1>&);
template void add_wall_velocity<2>(const WallSurface&, const Families&, const double*,
                                   const double*, Index, BondSums<2>&);
template void add_wall_velocity<3>(const WallSurface&, const Families&, const double*,
                                   const double*, Index, BondSums<3>&);

}  // namespace lapilli
