#pragma once

#include <algorithm>
#include <stdexcept>

#include "lapilli/core/diagnostics.hpp"
#include "lapilli/scene/build.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "scene/example_scenes.hpp"

/// A scene of heat on soil in motion, and what is seen of it.
namespace sub_cycling {

using namespace lapilli;

// Soil that falls apart on a wall while it is heated. Heat by itself would step 0.5 s, the motion
// takes 2 ms.
inline const std::string soil = R"(
[grid]
lower = [0.0, 0.0]
upper = [2.0, 1.0]
cell = 0.1
[[bodies]]
shape = {kind = "box", lower = [0.0, 0.0], upper = [0.5, 0.8]}
temperature = 0.2
source = 40.0
[[bodies.material]]
kind = "mohr_coulomb"
density = 2000.0
youngs_modulus = 1e6
poissons_ratio = 0.3
friction_angle = 30.0
[[bodies.material]]
kind = "thermal"
density = 2000.0
specific_heat = 1.0
conductivity = 1.0
[[bodies.material]]
kind = "plastic_heating"
[dynamics]
gravity = [0.0, -9.81]
[[dynamics.grid_boundaries]]
kind = "no_slip"
face = "y_lower"
[[dynamics.grid_boundaries]]
kind = "roller"
face = "x_lower"
[heat]
subcycling = true
[[heat.boundaries]]
kind = "convection"
name = "air"
coefficient = 10.0
ambient = {times = [0.0, 0.1, 0.1, 0.2], values = [1.0, 3.0, 1.0, 2.0]}
[time]
end = 0.3
)";

inline const std::string expansion = R"([[bodies.material]]
kind = "thermal_expansion"
coefficient = 1e-4
[dynamics])";

inline std::unique_ptr<Simulation> start(const std::string& text) {
  return build(parse_scene(text, ""));
}

inline std::unique_ptr<Simulation> at_end(const std::string& text) {
  auto simulation = start(text);
  simulation->run_until(simulation->end());
  return simulation;
}

inline std::string in_every_step(const std::string& text) {
  return replaced(text, "subcycling = true", "subcycling = false");
}

inline std::vector<double> by_id(Simulation& simulation, const std::string& name) {
  std::vector<double> sorted;
  const auto take = [&](std::span<const double> values, int width) {
    sorted.resize(values.size());
    for (Index row = 0; row < simulation.points().size(); ++row) {
      const Index to = simulation.points().id()[row];
      std::copy_n(values.begin() + row * width, width, sorted.begin() + to * width);
    }
  };
  if (name == "position") {
    take(simulation.points().position(), 2);
  }
  for (const Field& field : simulation.fields()) {
    if (field.name == name) {
      take(field.values, field.components);
    }
  }
  return sorted;
}

inline double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
  double largest = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    largest = std::max(largest, std::abs(one[k] - other[k]));
  }
  return largest;
}

/// Fields and balances: all that anybody sees.
inline std::vector<double> everything(Simulation& simulation) {
  std::vector<double> all = by_id(simulation, "position");
  for (const Field& field : simulation.fields()) {
    const std::vector<double> values = by_id(simulation, field.name);
    all.insert(all.end(), values.begin(), values.end());
  }
  for (const Balance& balance : simulation.balances()) {
    all.push_back(balance.stored);
    all.push_back(balance.supplied());
  }
  return all;
}

inline double steps_of(Simulation& simulation) {
  for (const Scalar& scalar : diagnostics_of(simulation)) {
    if (scalar.name == "heat/steps_per_heat_step") {
      return scalar.value;
    }
  }
  return 1.0;
}

inline double entry(const Simulation& simulation, std::size_t balance, const std::string& name) {
  const std::vector<Balance> all = simulation.balances();
  for (const Balance::Entry& one : all[balance].entries) {
    if (one.name == name) {
      return one.in;
    }
  }
  throw std::runtime_error("no entry " + name);
}

}  // namespace sub_cycling
