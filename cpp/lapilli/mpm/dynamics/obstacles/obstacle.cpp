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

/// Keys of obstacles with a mass, and that others have none of them.
void check_free(const Obstacle& obstacle, int dimension, const std::string& where) {
  if (!obstacle.mass) {
    require(obstacle.inertia.empty() && obstacle.force.empty() && obstacle.held.empty(), where,
            ": inertia, force and held belong to an obstacle with a mass");
    return;
  }
  require(std::isfinite(*obstacle.mass) && *obstacle.mass > 0.0, where,
          ".mass must be above 0, got ", *obstacle.mass);
  require(obstacle.factor.is_constant() && obstacle.factor.at(0.0) == 1.0, where,
          ".factor belongs to a prescribed motion; this obstacle has a mass");
  const std::size_t turns = dimension == 2 ? 1 : 3;
  require(obstacle.inertia.empty() || obstacle.inertia.size() == turns, where, ".inertia needs ",
          turns, dimension == 2 ? " number in two" : " numbers in three", " dimensions, got ",
          obstacle.inertia.size());
  for (const double about : obstacle.inertia) {
    require(std::isfinite(about) && about > 0.0, where, ".inertia must be above 0, got ", about);
  }
  require(obstacle.force.empty() || static_cast<int>(obstacle.force.size()) == dimension, where,
          ".force needs ", dimension, " values, one an axis, got ", obstacle.force.size());
  for (const Value& along : obstacle.force) {
    require(!along.is_function(), where,
            ".force must be numbers or tables in time: a function of place acts on nothing rigid");
  }
  const std::string axes = dimension == 2 ? "xy" : "xyz";
  for (const std::string& what : obstacle.held) {
    const bool is_axis = what.size() == 1 && axes.find(what) != std::string::npos;
    require(is_axis || what == "rotation", where, ".held must be among \"x\", \"y\"",
            dimension == 3 ? ", \"z\"" : "", ", \"rotation\", got \"", what, "\"");
  }
}

/// Keys of obstacles that exchange heat.
void check_heat(const Obstacle& obstacle, const std::string& where) {
  if (!obstacle.temperature) {
    require(!obstacle.conductance && !obstacle.heat_capacity, where,
            ": conductance and heat_capacity belong to an obstacle with a temperature");
    return;
  }
  require(!obstacle.temperature->is_function(), where,
          ".temperature must be a number or a table in time: an obstacle has one");
  require(!obstacle.conductance || !obstacle.conductance->is_function(), where,
          ".conductance must be a number or a table in time");
  require(!obstacle.heat_capacity || obstacle.temperature->is_constant(), where,
          ".temperature is that at the start where there is a heat_capacity: a number, no table");
}

}  // namespace

std::string name_of(const Obstacle& obstacle, std::size_t index) {
  return obstacle.name.empty() ? message("obstacle ", index) : obstacle.name;
}

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
  check_free(obstacle, dimension, where);
  check_heat(obstacle, where);
}

}  // namespace lapilli
