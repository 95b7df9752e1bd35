#include "lapilli/peridynamics/diagnostics.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

double volume_mean_nusselt(const Points& points, const Flow& flow, const PeridynamicHeat& heat,
                           int axis, const NusseltScale& scale) {
  const int dimension = points.dimension();
  double carried = 0.0, volume = 0.0;
  for (Index i = 0; i < points.size(); ++i) {
    if (heat.walls().wall(i) < 0) {
      const double v = points.volume()[i];
      carried += v * flow.velocity()[i * dimension + axis] * heat.temperature()[i];
      volume += v;
    }
  }
  const double diffusivity = heat.material().diffusivity();
  return 1.0 + carried / volume * scale.length / (diffusivity * scale.range);
}

double wall_nusselt(const PeridynamicHeat& heat, int wall, const NusseltScale& scale) {
  return heat.wall_power(wall) * scale.length /
         (heat.wall_area(wall) * heat.material().conductivity() * scale.range);
}

double wall_flux_near(const Points& points, const PeridynamicHeat& heat, const Vec3& place,
                      double reach) {
  double flux = 0.0, total = 0.0;
  for (Index i = 0; i < points.size(); ++i) {
    if (heat.met_area()[i] > 0.0) {
      const double squared = (heat.walls().place(i) - place).squaredNorm();
      const double w = heat.met_area()[i] * std::exp(-squared / (reach * reach));
      flux += w * heat.wall_heat_flux()[i];
      total += w;
    }
  }
  return total > 0.0 ? flux / total : 0.0;
}

double sample_fluid(const Points& points, const WallSurface& walls, std::span<const double> values,
                    int components, int component, const Vec3& place, double reach) {
  const int dimension = points.dimension();
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  int used = 0;
  for (Index i = 0; i < points.size(); ++i) {
    if (walls.wall(i) >= 0) {
      continue;
    }
    Eigen::Vector4d basis(1.0, 0.0, 0.0, 0.0);
    double squared = 0.0;
    for (int d = 0; d < dimension; ++d) {
      basis[1 + d] = (points.position()[i * dimension + d] - place[d]) / reach;
      squared += basis[1 + d] * basis[1 + d];
    }
    if (squared < 1.0) {
      const double weight = std::exp(-6.0 * squared);
      normal += weight * basis * basis.transpose();
      right += weight * values[i * components + component] * basis;
      ++used;
    }
  }
  require(used > dimension, "only ", used, " fluid points lie within ", reach, " m of (", place[0],
          ", ", place[1], ", ", place[2], ")");
  for (int d = dimension; d < 3; ++d) {
    normal(1 + d, 1 + d) = 1.0;
  }
  return normal.ldlt().solve(right)[0];
}

}  // namespace lapilli
