#include "lapilli/scene/shallow_heat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lapilli/core/in_brackets.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/geometry/come_near.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/region_on_body.hpp"
#include "lapilli/scene/validate_heat.hpp"

namespace lapilli {
namespace {

// All sizes are of the heat taken up, against series, at four angles and places or more.
constexpr double held_from = 100.0;             // conductivities / cell
constexpr double least_warming = 0.03;          // of the way to the surroundings, about
constexpr double told = 1.0, most_told = 60.0;  // percent

/// How far heat has come into a body by the end of the run.
struct Depth {
  std::size_t body = 0;
  double metres = 0.0, cells = 0.0;
};

struct Shallow {
  double percent = 0.0;
  Depth depth;
  double wanted = 0.0;  // cells
  std::string giver;
};

/// Bodies at rest. With a coefficient of .2, 1, 4, 20 conductivities / cell 2.6, 14, 46, 30 % too
/// much where heat is .3 cells deep, 1.4, 5.5, 4.8, 2.4 % at 1.1, .6, 1.0, 1.5, 1.1 % at 1.9, and
/// about as much as the surface has warmed before. Held: -40 % at .1 cells, 15 % at .3, 2 % at .6
/// to 1.
double percent_at_rest(double strength, double cells) {
  if (strength > held_from) {
    return 1.5 / (cells * cells);
  }
  const double share = std::min(1.0, 1.6 * std::pow(strength, 0.85));
  const double power = 1.35 + 0.9 * std::log10(strength);
  const double percent =
      cells < 1.2 ? 4.9 * std::pow(1.2 / cells, power) : 8.5 / std::pow(cells, 3);
  return std::min(share * percent, 80.0 * strength * cells);
}

/// Bodies whose surface is known by points: held -16, -8.8, -5, -2.3, -.8 %
/// at 1.2, 1.5, 1.8, 2.2, 2.7 cells. Exchange has a note of its own.
double percent_of_points(double strength, double cells) {
  return strength > held_from ? 27.0 / std::pow(cells, 3) : 0.0;
}

/// Obstacles: perfect contacts and 100 conductivities / cell 28, 16, 11, 4.7, 2.2, .5 % too little
/// at .42, .6, .85, 1.2, 1.7, 2.7 cells; .8 conductivities / cell 3.4, 3.2, 1.9, .7 % from .85 on.
/// Perfect ones at an angle, or within .2 cells before a node, up to 8.4, 6.6, 5.2, 4, 2.8 % too
/// much at 1.1, 1.4, 1.8, 2.4, 3.4 cells, half of that in the mean: boxes of joined points conduct
/// more.
double percent_of_obstacle(double strength, double cells) {
  const double most = 7.5 + 5.5 / (1.0 + 5.0 / strength);
  return std::min(1.0, 0.2 + 0.8 * strength) * most / (cells * cells);
}

/// Bodies in contact that move: 3 % at one cell for conductivities that are alike, 9 and 15 % for a
/// contrast of 4 and 40; a fourth of that at two cells.
double percent_of_contact(double contrast, double cells) {
  return (3.0 + 14.0 * (1.0 - 1.0 / std::sqrt(contrast))) / (cells * cells);
}

/// Walls of peridynamics, held or by convection of one conductivity / spacing and more: 15, 7.5, 3,
/// 1.7, .8 % too little at .7, 1, 1.5, 2, 3 spacings.
double percent_of_wall(double strength, double spacings) {
  return std::min(1.0, 0.5 + 0.5 * strength) * 7.0 / (spacings * spacings);
}

/// Where so many percent become too few to tell.
template <class Percent>
double wanted_cells(const Percent& percent) {
  double cells = 0.5;
  while (percent(cells) >= told && cells < 20.0) {
    cells += 0.1;
  }
  return cells;
}

bool always() { return true; }

template <class Percent, class Acts>
void take(std::optional<Shallow>& worst, const Depth& depth, const std::string& giver,
          const Percent& percent, const Acts& acts) {
  const double here = std::min(percent(depth.cells), most_told);
  if (here >= told && here > (worst ? worst->percent : 0.0) && acts()) {
    worst = {here, depth, wanted_cells(percent), giver};
  }
}

/// Whether heat passes at all.
bool differ(const Value& one, const Value& other) {
  return one.is_function() || other.is_function() || one.least() != other.largest() ||
         one.largest() != other.least();
}

std::string called(const Scene& scene, std::size_t body) {
  const std::string& name = scene.bodies[body].name;
  return message("bodies.", body, in_brackets(name));
}

Depth depth_in(const Scene& scene, std::size_t k, const Thermal& thermal) {
  const double metres = depth_of_heat(thermal, scene.time.end);
  return {k, metres, metres / scene.grid.cell};
}

void look_at_conditions(const Scene& scene, const Depth& depth, double conductivity,
                        std::optional<Shallow>& worst) {
  const Value& temperature = scene.bodies[depth.body].temperature;
  const double zero = absolute_zero(*scene.heat);
  const double start =
      temperature.is_function() ? 0.0 : std::max(0.0, temperature.largest() - zero);
  const bool of_points = is_heat_of_points(scene);
  for (std::size_t law = 0; law < scene.heat->boundaries.size(); ++law) {
    const HeatBoundary& one = scene.heat->boundaries[law];
    const double strength = largest_coefficient(one, start, zero) * scene.grid.cell / conductivity;
    if (!(strength > 0.0) || !(holds_temperature(one) || std::isfinite(strength))) {
      continue;
    }
    const auto percent = [&](double cells) {
      return of_points ? percent_of_points(strength, cells) : percent_at_rest(strength, cells);
    };
    take(worst, depth, message("heat.boundaries.", law), percent, [&] {
      const Shape* region = scene.bodies.size() > 1 ? region_of(one) : nullptr;
      return region == nullptr || lies_on(scene, *region, depth.body);
    });
  }
}

void look_at_obstacles(const Scene& scene, const Depth& depth, double conductivity,
                       std::optional<Shallow>& worst) {
  for (std::size_t k = 0; scene.dynamics && k < scene.dynamics->obstacles.size(); ++k) {
    const Obstacle& one = scene.dynamics->obstacles[k];
    if (!one.temperature || !differ(*one.temperature, scene.bodies[depth.body].temperature)) {
      continue;
    }
    const double strength = one.conductance
                                ? one.conductance->largest() * scene.grid.cell / conductivity
                                : std::numeric_limits<double>::infinity();
    if (strength * depth.cells >= least_warming) {
      take(
          worst, depth, message("dynamics.obstacles.", k),
          [&](double cells) { return percent_of_obstacle(strength, cells); }, always);
    }
  }
}

bool may_touch(const Body& one, const Body& other, double cell) {
  const std::optional<Shape> a = placed_shape(one), b = placed_shape(other);
  return !a || !b || come_near(*a, *b, cell, cell);
}

/// With the bodies after it that start at another temperature.
void look_at_contacts(const Scene& scene, const Depth& depth, const Thermal& thermal,
                      std::optional<Shallow>& worst) {
  const Body& body = scene.bodies[depth.body];
  if (!scene.dynamics || scene.dynamics->contacts.empty() || body.temperature.is_function()) {
    return;
  }
  for (std::size_t k = depth.body + 1; k < scene.bodies.size(); ++k) {
    const Body& other = scene.bodies[k];
    const auto* its = material_in<Thermal>(other);
    if (its == nullptr || other.temperature.is_function() ||
        !differ(other.temperature, body.temperature)) {
      continue;
    }
    const double one = largest_conductivity(thermal), two = largest_conductivity(*its);
    const double contrast = std::max(one, two) / std::max(std::min(one, two), 1e-300);
    const Depth there = depth_in(scene, k, *its);
    take(
        worst, there.cells < depth.cells ? there : depth,
        message("the contact of ", called(scene, depth.body), " and ", called(scene, k)),
        [&](double cells) { return percent_of_contact(contrast, cells); },
        [&] { return may_touch(body, other, scene.grid.cell); });
  }
}

/// Of peridynamics; `depth.cells` are spacings.
void look_at_walls(const Scene& scene, Depth depth, double conductivity,
                   std::optional<Shallow>& worst) {
  const int along_axis = points_along_axis(scene.bodies[depth.body], dimension_of(scene));
  const double spacing = scene.grid.cell / along_axis;
  depth.cells = depth.metres / spacing;
  for (std::size_t k = 0; k < scene.peridynamics->walls.size(); ++k) {
    const FluidWallBody& wall = scene.peridynamics->walls[k];
    if (!differ(wall.temperature, scene.bodies[depth.body].temperature)) {
      continue;
    }
    const bool holds = wall.heat == WallHeat::temperature;
    const double strength = holds ? std::numeric_limits<double>::infinity()
                            : wall.heat == WallHeat::convection
                                ? wall.coefficient * spacing / conductivity
                                : 0.0;
    if (strength * depth.cells >= least_warming) {
      take(
          worst, depth, message("peridynamics.walls.", k),
          [&](double cells) { return percent_of_wall(strength, cells); }, always);
    }
  }
}

}  // namespace

std::vector<Note> shallow_heat(const Scene& scene) {
  std::optional<Shallow> worst;
  const bool by_walls = scene.peridynamics && scene.peridynamics->heat && !scene.peridynamics->flow;
  for (std::size_t k = 0; (scene.heat || by_walls) && k < scene.bodies.size(); ++k) {
    const auto* thermal = material_in<Thermal>(scene.bodies[k]);
    if (thermal == nullptr || !(largest_conductivity(*thermal) > 0.0)) {
      continue;
    }
    const Depth depth = depth_in(scene, k, *thermal);
    if (by_walls) {
      look_at_walls(scene, depth, largest_conductivity(*thermal), worst);
      continue;
    }
    look_at_conditions(scene, depth, largest_conductivity(*thermal), worst);
    look_at_obstacles(scene, depth, largest_conductivity(*thermal), worst);
    look_at_contacts(scene, depth, *thermal, worst);
  }
  if (!worst) {
    return {};
  }
  return {note("heat.shallow", called(scene, worst->depth.body), ": heat comes ",
               worst->depth.metres, " m deep by time.end, ", worst->depth.cells,
               by_walls ? " spacings: so early what " : " cells: so early what ", worst->giver,
               " gives is off by up to ", std::round(10.0 * worst->percent) / 10.0, " %; with ",
               by_walls ? "points " : "grid.cell = ", worst->depth.metres / worst->wanted,
               by_walls ? " m apart it is right to " : " it is right to ", told, " %")};
}

}  // namespace lapilli
