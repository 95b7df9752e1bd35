#include "lapilli/peridynamics/flow_places.hpp"

#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

template <int Dim>
void check_places(const Points& points, const WallSurface& walls, const Families& families,
                  const PointArray& velocity) {
  for (Index i = 0; i < points.size(); ++i) {
    if (walls.wall(i) >= 0) {
      continue;
    }
    const auto place = [&] {
      std::string text;
      for (int d = 0; d < Dim; ++d) {
        text += message(d > 0 ? ", " : "", points.position()[i * Dim + d]);
      }
      return text;
    };
    if (families.end(i) - families.begin(i) < Dim + 1) {
      throw RunError(message("point ", points.id()[i], " has escaped to (", place(),
                             ") and has lost its family: its velocity there is ",
                             Eigen::Map<const Vec<Dim>>(velocity.data() + i * Dim).norm(),
                             " m/s; a gap in the walls, or too long a step"));
    }
    double nearest = 1e300, ahead = 0.0;
    int wall = -1;
    for (Index bond = families.wall_begin(i); bond < families.end(i); ++bond) {
      const Index j = families.neighbour(bond);
      const double squared = (points.position<Dim>(j) - points.position<Dim>(i)).squaredNorm();
      if (squared < nearest) {
        nearest = squared;
        ahead = walls.template distance<Dim>(points.position().data() + i * Dim, j);
        wall = walls.wall(j);
      }
    }
    if (ahead < -0.5 * walls.spacing()) {
      throw RunError(message("point ", points.id()[i], " has escaped through wall '",
                             walls.walls()[wall].settings.name, "' at (", place(), "): it lies ",
                             -ahead, " m behind its surface"));
    }
  }
}

template <int Dim>
void part_coincident_points(Points& points, const WallSurface& walls, const Families& families) {
  // Shifting spreads points that are close, but two in one place have no direction to part in.
  const double together = 1e-6 * walls.spacing(), apart = 1e-2 * walls.spacing();
  bool parted = false;
  for (Index i = 0; i < points.size(); ++i) {
    for (Index bond = families.begin(i); bond < families.end(i) && walls.wall(i) < 0; ++bond) {
      const Index j = families.neighbour(bond);
      if (points.id()[j] < points.id()[i] &&
          (points.position<Dim>(i) - points.position<Dim>(j)).norm() < together) {
        for (int d = 0; d < Dim; ++d) {
          points.position()[i * Dim + d] +=
              apart * std::cos(static_cast<double>(points.id()[i]) + 1.5707963 * d);
        }
        parted = true;
      }
    }
  }
  if (parted) {
    points.moved();
  }
}

template void check_places<1>(const Points&, const WallSurface&, const Families&,
                              const PointArray&);
template void part_coincident_points<1>(Points&, const WallSurface&, const Families&);
template void check_places<2>(const Points&, const WallSurface&, const Families&,
                              const PointArray&);
template void part_coincident_points<2>(Points&, const WallSurface&, const Families&);
template void check_places<3>(const Points&, const WallSurface&, const Families&,
                              const PointArray&);
template void part_coincident_points<3>(Points&, const WallSurface&, const Families&);

}  // namespace lapilli
