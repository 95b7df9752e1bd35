#include "lapilli/scene/validate_heat.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "lapilli/core/in_brackets.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/asks_for_points.hpp"
#include "lapilli/mpm/heat/heat_in_body_frame.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/mpm/surface/surface_conditions.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/common_motion.hpp"
#include "lapilli/scene/idle_rules.hpp"
#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/shallow_heat.hpp"

namespace lapilli {
namespace {

bool radiates(const Scene& scene) {
  return scene.heat && any_needs_absolute(scene.heat->boundaries);
}

/// Call body(value, path) for every temperature that a scene with [heat] gives.
template <class Body>
void for_each_temperature(const Scene& scene, const Body& body) {
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    body(scene.bodies[k].temperature, message("bodies.", k, ".temperature"));
  }
  for (std::size_t k = 0; k < scene.heat->boundaries.size(); ++k) {
    const HeatBoundary& law = scene.heat->boundaries[k];
    if (const Value* surroundings = surroundings_of(law)) {
      body(*surroundings, message("heat.boundaries.", k, ".", key_of_surroundings(law)));
    }
  }
  for (std::size_t k = 0; scene.dynamics && k < scene.dynamics->obstacles.size(); ++k) {
    if (const auto& temperature = scene.dynamics->obstacles[k].temperature) {
      body(*temperature, message("dynamics.obstacles.", k, ".temperature"));
    }
  }
}

}  // namespace

void validate_heat(const Scene& scene) {
  for (std::size_t k = 0; scene.dynamics && k < scene.dynamics->obstacles.size(); ++k) {
    require_at(scene.heat || !scene.dynamics->obstacles[k].temperature, scene,
               message("dynamics.obstacles.", k, ".temperature"), "has no effect without [heat]");
  }
  if (!radiates(scene)) {
    return;
  }
  const double zero = absolute_zero(*scene.heat);
  const char* hint = scene.heat->unit ? "" : "; for degrees Celsius set heat.temperature_unit";
  for_each_temperature(scene, [&](const Value& value, const std::string& path) {
    require_at(value.is_function() || value.least() >= zero, scene, path,
               "must be at least absolute zero, ", zero, ", where surfaces radiate, got ",
               value.least(), hint);
  });
}

namespace {

/// That temperatures under radiation look like degrees Celsius; none if not.
std::optional<Note> celsius_warning(const Scene& scene) {
  constexpr double warm = 150.0;  // K; little that radiates is colder, much is hotter in Celsius
  if (!radiates(scene) || scene.heat->unit) {
    return {};
  }
  double highest = 0.0;
  for_each_temperature(scene, [&](const Value& value, const std::string&) {
    highest = std::max(highest, value.largest());
  });
  if (highest >= warm) {
    return {};
  }
  return note("heat.celsius", "no temperature is above ", highest,
              " K though surfaces radiate: are they degrees Celsius? Say heat.temperature_unit "
              "= \"celsius\" or \"kelvin\"");
}

/// Convection on the nodes of the band holds them all where it is strong: with 1, 3, 10, 30
/// conductivities / cell 3, 9, 18, 25 % too much where heat is 1.5 cells deep, 2, 4, 6, 8 % at 2.7.
double percent_too_strong(double strength, double cells) {
  const double deep = std::min(1.0, 1.8 / cells);
  return 28.0 * strength / (strength + 5.0) * deep * deep;
}

std::vector<Note> strong_convection_warnings(const Scene& scene) {
  std::vector<Note> all;
  double least = std::numeric_limits<double>::infinity();  // W/(m K)
  double cells = 0.0, warmest = 0.0;                       // of depth, in that body; K
  const double zero = absolute_zero(*scene.heat);
  for (const Body& body : scene.bodies) {
    const auto* thermal = material_in<Thermal>(body);
    if (thermal != nullptr && largest_conductivity(*thermal) < least) {
      least = largest_conductivity(*thermal);
      cells = depth_of_heat(*thermal, scene.time.end) / scene.grid.cell;
      warmest = body.temperature.is_function() ? 0.0 : body.temperature.largest() - zero;
    }
  }
  for (std::size_t law = 0; law < scene.heat->boundaries.size(); ++law) {
    const HeatBoundary& boundary = scene.heat->boundaries[law];
    if (holds_temperature(boundary)) {
      continue;
    }
    const double strength =
        largest_coefficient(boundary, std::max(warmest, 0.0), zero) * scene.grid.cell / least;
    const double percent = percent_too_strong(strength, cells);
    if (std::isfinite(strength) && (strength > 1.0 || (strength >= 0.5 && percent > 1.0))) {
      all.push_back(note(
          "heat.strong-convection", "heat.boundaries.", law, ": its coefficient is ",
          std::round(10.0 * strength) / 10.0,
          " times conductivity / cell, on bodies that deform or are known by their points: heat is "
          "up to ",
          std::max(1.0, std::round(percent)),
          " % too large by time.end; smaller cells, or a held temperature"));
    }
  }
  return all;
}

/// Parts of surfaces that deforming bodies have: the heat is concentrated at the ends of one that
/// is held, within a cell of which points tell little.
std::vector<Note> held_part_warnings(const Scene& scene) {
  std::vector<Note> all;
  for (std::size_t law = 0; law < scene.heat->boundaries.size(); ++law) {
    const HeatBoundary& boundary = scene.heat->boundaries[law];
    if (holds_temperature(boundary) && region_of(boundary) != nullptr) {
      all.push_back(note(
          "heat.held-part", "heat.boundaries.", law,
          ": holds the temperature within a region, on bodies that deform ",
          "or are known by their points: where the region ends on a surface, heat is off by about ",
          "4 % for a part 10 cells (", 10.0 * scene.grid.cell, " m) wide, in proportion to cell ",
          "over width"));
    }
  }
  return all;
}

/// A temperature exactly at a single melting point says nothing of the state there.
std::optional<Note> melting_point_note(const Body& body, std::size_t k) {
  const auto* thermal = material_in<Thermal>(body);
  const bool at_it = thermal != nullptr && thermal->melts() && body.temperature.is_constant() &&
                     thermal->melting_begins() == thermal->melting_ends() &&
                     body.temperature.at(0.0) == thermal->melting_begins();
  if (!at_it) {
    return {};
  }
  return note("heat.melting-point-start", "bodies.", k,
              ".temperature is the melting point itself: the body starts ",
              "solid; set it a little above to start liquid");
}

/// A start has one instant: of a table in time the value there is taken, and no other.
std::optional<Note> start_note(const Body& body, std::size_t k) {
  const Value& start = body.temperature;
  if (!std::holds_alternative<Table>(start.form()) || start.least() == start.largest()) {
    return {};
  }
  const std::string name = in_brackets(body.name);
  return note("heat.start-table", "bodies.", k, ".temperature", name,
              " is a table in time, of which only ", start.at(0.0),
              ", the value at the start, is taken: what holds a temperature ",
              "later is a boundary condition");
}

/// Whether a turn leaves the conductivity as it is.
bool is_isotropic(const Thermal& thermal, int dimension) {
  if (thermal.conductivity.varies()) {
    return true;
  }
  const SymmetricTensor& k = thermal.conductivity.constant();
  constexpr int xx = 0, yy = 1, xy = 3;
  return dimension == 2 ? k[xx] == k[yy] && k[xy] == 0.0 : k.is_scalar();
}

/// Conductivities are given, and stay, along the axes of the grid, but for bodies that one rigid
/// motion moves, whose axes turn with it.
std::optional<Note> axes_note(const Scene& scene, std::size_t k) {
  const Body& body = scene.bodies[k];
  const auto* thermal = material_in<Thermal>(body);
  if (!scene.heat || thermal == nullptr || is_isotropic(*thermal, dimension_of(scene))) {
    return {};
  }
  const bool by_points = has_moving_points(scene) &&
                         !bears_body_frame(*scene.heat, common_motion(scene), dimension_of(scene));
  const bool turns =
      scene.dynamics || (body.motion && !std::holds_alternative<Translation>(*body.motion));
  if (by_points && turns) {
    return note("heat.conductivity-axes", "bodies.", k,
                ".material: the axes of its conductivity stay those of the grid ",
                "where the body turns");
  }
  if (body.rotation == 0.0) {
    return {};
  }
  return note("heat.conductivity-axes", "bodies.", k,
              ".rotation does not turn the conductivity, which is given ",
              "along the axes of the grid");
}

/// Buoyancy is that of a small expansion. Scenes in units of their own (expansion 1 over a
/// temperature difference of 1) are right as they are: only differences beyond 10 K are judged.
std::optional<Note> expansion_note(const Scene& scene) {
  constexpr double small = 0.2, counted = 10.0;  // of the volume; K
  if (!scene.peridynamics || !scene.peridynamics->flow || !scene.peridynamics->heat) {
    return {};
  }
  double least = std::numeric_limits<double>::infinity(), most = -least, expansion = 0.0;
  const auto take = [&](const Value& temperature) {
    least = std::min(least, temperature.least());
    most = std::max(most, temperature.largest());
  };
  for (const Body& body : scene.bodies) {
    take(body.temperature);
    if (const auto* fluid = material_in<Newtonian>(body)) {
      expansion = std::max(expansion, std::abs(fluid->thermal_expansion));
    }
  }
  for (const FluidWallBody& wall : scene.peridynamics->walls) {
    if (wall.heat == WallHeat::temperature || wall.heat == WallHeat::convection) {
      take(wall.temperature);
    }
  }
  const double range = most - least;
  if (!(range > counted && std::isfinite(range) && expansion * range > small)) {
    return {};
  }
  return note("peridynamics.large-expansion", "temperatures from ", least, " to ", most,
              " K change the volume of the fluid by about ", std::round(100.0 * expansion * range),
              " %: buoyancy in proportion to temperature is good to about 10 to 20 %; are some "
              "temperatures degrees Celsius?");
}

}  // namespace

bool is_heat_of_points(const Scene& scene) {
  return asks_for_points(*scene.heat) ||
         (has_moving_points(scene) &&
          !bears_body_frame(*scene.heat, common_motion(scene), dimension_of(scene))) ||
         std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return !body.shape; });
}

std::vector<Note> heat_warnings(const Scene& scene) {
  std::vector<Note> all;
  if (const std::optional<Note> celsius = celsius_warning(scene)) {
    all.push_back(*celsius);
  }
  if (const std::optional<Note> expands = expansion_note(scene)) {
    all.push_back(*expands);
  }
  for (std::size_t k = 0; scene.heat && k < scene.bodies.size(); ++k) {
    // Measured on disks and squares: lattices and jitter of a quarter, then random points.
    if (!scene.bodies[k].shape && !scene.heat->boundaries.empty()) {
      all.push_back(note("heat.surface-of-points", "bodies.", k,
                         " is known by its points alone: the area of its surface is right to 1 "
                         "to 2 %, of points strewn at random to 8 %, and does not converge; "
                         "give its shape"));
    }
  }
  for (std::size_t k = 0; !without_heat(scene) && k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    for (const std::optional<Note>& one :
         {start_note(body, k), melting_point_note(body, k), axes_note(scene, k)}) {
      if (one) {
        all.push_back(*one);
      }
    }
  }
  std::ranges::move(shallow_heat(scene), std::back_inserter(all));
  if (scene.heat && is_heat_of_points(scene)) {
    std::ranges::move(strong_convection_warnings(scene), std::back_inserter(all));
    std::ranges::move(held_part_warnings(scene), std::back_inserter(all));
  }
  return all;
}

}  // namespace lapilli
