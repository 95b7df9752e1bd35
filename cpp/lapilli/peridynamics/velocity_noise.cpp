#include "lapilli/peridynamics/velocity_noise.hpp"

#include <cmath>

namespace lapilli {

template <int Dim>
Vec<Dim> vessel_velocity(const WallSurface& walls) {
  Vec<Dim> sum = Vec<Dim>::Zero();
  Index count = 0;
  for (Index i = 0; i < walls.points().size(); ++i) {
    const int wall = walls.wall(i);
    if (wall >= 0) {
      ++count;
      if (const FluidWallSettings& settings = walls.walls()[wall].settings; settings.moves) {
        sum += Eigen::Map<const Vec<Dim>>(settings.velocity.data());
      }
    }
  }
  return count > 0 ? Vec<Dim>(sum / static_cast<double>(count)) : sum;
}

template <int Dim>
double velocity_noise(const WallSurface& walls, const Families& families, const BondWeight& weight,
                      const PointArray& velocity) {
  if (families.searches() == 0) {
    return 0.0;  // nothing has moved yet
  }
  const Points& points = walls.points();
  const Vec<Dim> vessel = vessel_velocity<Dim>(walls);
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
      total += (own - vessel).squaredNorm();
    }
  }
  return total > 0.0 ? std::sqrt(noise / total) : 0.0;
}

template Vec<1> vessel_velocity(const WallSurface&);
template Vec<2> vessel_velocity(const WallSurface&);
template Vec<3> vessel_velocity(const WallSurface&);
template double velocity_noise<1>(const WallSurface&, const Families&, const BondWeight&,
                                  const PointArray&);
template double velocity_noise<2>(const WallSurface&, const Families&, const BondWeight&,
                                  const PointArray&);
template double velocity_noise<3>(const WallSurface&, const Families&, const BondWeight&,
                                  const PointArray&);

}  // namespace lapilli
