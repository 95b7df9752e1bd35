#include "lapilli/scene/shallow_heat.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"

namespace lapilli {
namespace {

// Heat that a plane surface has taken up, against its series, at four angles and places. With a
// coefficient of .3, 1, 3, 10 conductivities / cell up to 4, 15, 38, 55 % too much where heat is .3
// cells deep; 2 to 4 % at 1.2. Held: -40 % at .1, +15 % at .3, 2 % at .6. With .1: 1 %.
constexpr double weakest = 0.25, held_from = 100.0;  // conductivities / cell
constexpr double held_depth = 0.55, deep = 1.2;      // cells
constexpr double least_warming = 0.03;               // of the way to the surroundings, about

struct Strongest {
  std::size_t law = 0;
  double strength = 0.0;  // conductivities / cell
};

/// Of the conditions that may act on a body.
Strongest strongest_on(const Scene& scene, const Body& body, double conductivity) {
  Strongest found;
  const double zero = absolute_zero(*scene.heat);
  for (std::size_t law = 0; law < scene.heat->boundaries.size(); ++law) {
    const HeatBoundary& one = scene.heat->boundaries[law];
    if (scene.bodies.size() > 1 && region_of(one) != nullptr) {
      continue;
    }
    const double start = body.temperature.is_function() ? 0.0 : body.temperature.largest() - zero;
    const double strength =
        largest_coefficient(one, std::max(start, 0.0), zero) * scene.grid.cell / conductivity;
    const bool known = holds_temperature(one) || std::isfinite(strength);
    if (known && strength > found.strength) {
      found = {law, strength};
    }
  }
  return found;
}

}  // namespace

std::vector<Note> shallow_heat(const Scene& scene) {
  std::vector<Note> all;
  double least = 1.0;  // of the depth that would do
  for (std::size_t k = 0; scene.heat && k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    const auto* thermal = material_in<Thermal>(body);
    if (thermal == nullptr) {
      continue;
    }
    const double conductivity = largest_conductivity(*thermal);
    const double depth = std::sqrt(conductivity / thermal->capacity() * scene.time.end);
    const double cells = depth / scene.grid.cell;
    const auto [law, strength] = strongest_on(scene, body, conductivity);
    const double wanted = strength > held_from ? held_depth : deep;
    if (strength < weakest || strength * cells < least_warming || !(cells / wanted < least)) {
      continue;
    }
    least = cells / wanted;
    const std::string name = body.name.empty() ? std::string() : message(" (", body.name, ")");
    all = {note("heat.shallow", "bodies.", k, name, ": heat comes ", depth, " m deep by time.end, ",
                cells, " cells: so early what heat.boundaries.", law,
                " gives is off by some percent, below half a cell by a tenth to a half; with "
                "grid.cell = ",
                depth / 1.5, " it is right")};
  }
  return all;
}

}  // namespace lapilli
