#include "lapilli/peridynamics/sound_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/checks.hpp"
#include "lapilli/peridynamics/heat.hpp"

namespace lapilli {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Span {
  double least = infinity, most = -infinity;

  void take(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  void take(const Value& value) {
    if (const auto* table = std::get_if<Table>(&value.form())) {
      for (const double one : table->values) {
        take(one);
      }
    } else {
      take(value.at(0.0));
    }
  }
  double size() const { return most > least ? most - least : 0.0; }
  double greatest_size() const { return std::max({0.0, std::abs(least), std::abs(most)}); }
};

/// What the source of a body spans, W/m^3; of a function, at the start.
Span at_start(const FluidBody& body, const Points& points, const WallSurface& walls,
              const PointArray& temperature) {
  Span source;
  if (!body.source.is_function()) {
    source.take(body.source);
    return source;
  }
  std::vector<Vec3> place;
  std::vector<double> state;
  for (Index i = 0; i < points.size(); ++i) {
    if (points.body()[i] == body.body) {
      place.push_back(walls.place(i));
      state.push_back(temperature[i]);
    }
  }
  std::vector<double> values(place.size());
  body.source.evaluate(place, state, 0.0, values);
  for (const double value : values) {
    source.take(value);
  }
  return source;
}

double extent_along(const Points& points, const WallSurface& walls, const Vec3& direction) {
  Span span;
  for (Index i = 0; i < points.size(); ++i) {
    if (walls.wall(i) < 0) {
      span.take(direction.dot(walls.place(i)));
    }
  }
  return span.size() + walls.spacing();
}

double length_of(const Points& points, const WallSurface& walls, const Vec3& gravity) {
  if (gravity.norm() > 0.0) {
    return extent_along(points, walls, gravity.normalized());
  }
  double least = infinity;
  for (int d = 0; d < points.dimension(); ++d) {
    least = std::min(least, extent_along(points, walls, Vec3::Unit(d)));
  }
  return least;
}

double temperature_range(const Points& points, const PeridynamicHeat& heat, double length) {
  const WallSurface& walls = heat.walls();
  const Fluid& fluid = heat.material();
  Span temperature;
  double driven = 0.0;  // K m/W, over the conductivity
  for (const FluidWall& wall : walls.walls()) {
    const WallHeat kind = wall.settings.heat;
    if (kind == WallHeat::temperature || kind == WallHeat::convection) {
      temperature.take(wall.settings.temperature);
    } else if (kind == WallHeat::flux) {
      Span flux;
      flux.take(wall.settings.flux);
      driven = std::max(driven, flux.greatest_size() * length);
    }
  }
  for (const FluidBody& body : fluid.bodies) {
    const Span source = at_start(body, points, walls, heat.temperature());
    driven = std::max(driven, source.greatest_size() * length * length / 8.0);
  }
  for (Index i = 0; i < points.size(); ++i) {
    if (walls.wall(i) < 0) {
      temperature.take(heat.temperature()[i]);
    }
  }
  if (const double given = fluid.newtonian.reference_temperature; given != 0.0) {
    temperature.take(given);
  }
  const double conductivity = fluid.conductivity();
  return std::max(temperature.size(), conductivity > 0.0 ? driven / conductivity : 0.0);
}

}  // namespace

double choose_sound_speed(const Points& points, const WallSurface& walls,
                          const PeridynamicFlowSettings& settings, const Fluid& fluid,
                          const PeridynamicHeat* heat) {
  if (settings.sound_speed > 0.0) {
    return settings.sound_speed;
  }
  double moving = 0.0;  // m/s
  for (const FluidWall& wall : walls.walls()) {
    moving = std::max(moving, place(wall.settings.velocity).norm());
  }
  for (const FluidBody& body : fluid.bodies) {
    moving = std::max(moving, place(body.velocity).norm());
  }
  const Vec3 gravity = place(settings.gravity);
  const double length = settings.length > 0.0 ? settings.length : length_of(points, walls, gravity);
  double range = settings.temperature_range;
  if (range == 0.0 && heat != nullptr) {
    range = temperature_range(points, *heat, length);
  }
  const double drive =
      gravity.norm() * std::abs(fluid.newtonian.thermal_expansion) * range;  // m/s^2
  const double speed =
      std::max({settings.sound_speed_factor * std::sqrt(drive * length), 10.0 * moving,
                10.0 * fluid.newtonian.viscosity / fluid.newtonian.density / length});
  require(
      speed > 0.0,
      "no sound speed follows from this scene (no buoyancy, no moving wall, no viscosity): give "
      "sound_speed");
  return speed;
}

}  // namespace lapilli
