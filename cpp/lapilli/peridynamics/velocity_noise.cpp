#include "lapilli/peridynamics/velocity_noise.hpp"

#include <cmath>

namespace lapilli {

template <int Dim>
double velocity_noise(const WallSurface& walls, const Families& families, const BondWeight& weight,
                      const PointArray& velocity) {
  if (families.searches() == 0) {
    return 0.0;  // nothing has moved yet
  }
  const Points& points = walls.points();
  double noise = 0.0, total = 0.0;
  for (Index i = 0; i < points.size(); ++i) {
    if (walls.wall(i) >= 0) {
      continue;
    }
    Vec<Dim> mean = Vec<Dim>::Zero();
    double total_weight = 0.0;
    const Eigen::Map<const Vec<Dim>> own(velocity.data() + i * Dim);
    for (Index k = families.begin(i); k < families.end(i); ++k) {
      const Index j = families.neighbour(k);
      const double w =
          weight((points.position<Dim>(j) - points.position<Dim>(i)).norm()) * points.volume()[j];
      mean += w * Eigen::Map<const Vec<Dim>>(velocity.data() + j * Dim);
      total_weight += w;
    }
    if (total_weight > 0.0) {
      noise += (own - mean / total_weight).squaredNorm();
      total += own.squaredNorm();
    }
  }
  return total > 0.0 ? std::sqrt(noise / total) : 0.0;
}

template double velocity_noise<1>(const WallSurface&, const Families&, const BondWeight&,
                                  const PointArray&);
template double velocity_noise<2>(const WallSurface&, const Families&, const BondWeight&,
                                  const PointArray&);
template double velocity_noise<3>(const WallSurface&, const Families&, const BondWeight&,
                                  const PointArray&);

}  // namespace lapilli
