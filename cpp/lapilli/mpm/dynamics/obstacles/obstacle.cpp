#include "lapilli/mpm/dynamics/obstacles/obstacle.hpp"

#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

void check_vector(const std::vector<double>& values, int dimension, const std::string& what) {
  require(values.empty() || static_cast<int>(values.size()) == dimension, what, " needs ",
          dimension, " numbers, one an axis, got ", values.size());
  for (const double value : values) {
    require(std::isfinite(value), what, " must be finite, got ", value);
  }
}

}  // namespace

void check(const Obstacle& obstacle, int dimension, int index) {
  const std::string where = message("dynamics.obstacles.", index);
  check(obstacle.shape, dimension);
  require(std::isfinite(obstacle.friction) && obstacle.friction >= 0.0, where,
          ".friction must not be negative, got ", obstacle.friction);
  require(std::isfinite(obstacle.adhesion) && obstacle.adhesion >= 0.0, where,
          ".adhesion must not be negative, got ", obstacle.adhesion);
  require(obstacle.contact == ObstacleContact::frictional ||
              (obstacle.friction == 0.0 && obstacle.adhesion == 0.0),
          where, ".friction and .adhesion belong to contact = \"frictional\", this is ",
          name_of(obstacle.contact));
  check_vector(obstacle.velocity, dimension, where + ".velocity");
  check_vector(obstacle.center, dimension, where + ".center");
  require(std::isfinite(obstacle.revolutions_per_second), where,
          ".revolutions_per_second must be finite, got ", obstacle.revolutions_per_second);
  require(dimension == 2 || Eigen::Map<const Vec3>(obstacle.axis.data()).norm() > 0.0, where,
          ".axis needs a length above 0");
  require(!obstacle.factor.is_function(), where,
          ".factor must be a number or a table in time: a function of place moves nothing rigid");
}

}  // namespace lapilli
