#include "lapilli/peridynamics/velocity_noise.hpp"

#include <cmath>

namespace lapilli {

template <int Dim>
double velocity_noise(const WallSurface& walls, const Families& families,
                      std::span<const double> bond_weight, const PointArray& velocity) {
  if (bond_weight.empty()) {
    return 0.0;  // nothing has moved yet
  }
  double noise = 0.0, total = 0.0;
  for (Index i = 0; i < walls.points().size(); ++i) {
    if (walls.wall(i) >= 0) {
      continue;
    }
    Vec<Dim> mean = Vec<Dim>::Zero();
    double weight = 0.0;
    const Eigen::Map<const Vec<Dim>> own(velocity.data() + i * Dim);
    for (Index k = families.begin(i); k < families.end(i); ++k) {
      const Index j = families.neighbour(k);
      mean += bond_weight[k] * Eigen::Map<const Vec<Dim>>(velocity.data() + j * Dim);
      weight += bond_weight[k];
    }
    if (weight > 0.0) {
      noise += (own - mean / weight).squaredNorm();
      total += own.squaredNorm();
    }
  }
  return total > 0.0 ? std::sqrt(noise / total) : 0.0;
}

template double velocity_noise<1>(const WallSurface&, const Families&, std::span<const double>,
                                  const PointArray&);
template double velocity_noise<2>(const WallSurface&, const Families&, std::span<const double>,
                                  const PointArray&);
template double velocity_noise<3>(const WallSurface&, const Families&, std::span<const double>,
                                  const PointArray&);

}  // namespace lapilli
