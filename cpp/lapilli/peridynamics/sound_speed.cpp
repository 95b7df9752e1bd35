#include "lapilli/peridynamics/sound_speed.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/checks.hpp"

namespace lapilli {

double choose_sound_speed(const Points& points, const WallSurface& walls,
                          const PeridynamicFlowSettings& settings, const Newtonian& fluid,
                          double wall_range) {
  if (settings.sound_speed > 0.0) {
    return settings.sound_speed;
  }
  double wall_speed = 0.0;
  for (const Wall& wall : walls.walls()) {
    wall_speed = std::max(wall_speed, place(wall.settings.velocity).norm());
  }
  const Vec3 gravity = place(settings.gravity);
  const double g = gravity.norm();
  const Vec3 along = g > 0.0 ? Vec3(gravity / g) : Vec3(Vec3::UnitX());
  double least = 1e300, most = -1e300;
  for (Index i = 0; i < points.size(); ++i) {
    if (walls.wall(i) < 0) {
      double height = 0.0;
      for (int d = 0; d < points.dimension(); ++d) {
        height += along[d] * points.position()[i * points.dimension() + d];
      }
      least = std::min(least, height);
      most = std::max(most, height);
    }
  }
  const double length = settings.length > 0.0 ? settings.length : most - least + walls.spacing();
  const double range = settings.temperature_range > 0.0 ? settings.temperature_range : wall_range;
  const double drive =
      settings.buoyancy == Buoyancy::full ? g : g * std::abs(fluid.expansion) * range;
  const double speed =
      std::max({settings.sound_speed_factor * std::sqrt(drive * length), 10.0 * wall_speed,
                10.0 * fluid.viscosity / fluid.density / length});
  require(
      speed > 0.0,
      "no sound speed follows from this scene (no buoyancy, no moving wall, no viscosity): give "
      "sound_speed");
  return speed;
}

}  // namespace lapilli
