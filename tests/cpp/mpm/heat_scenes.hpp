#pragma once

#include <cmath>
#include <memory>

#include "lapilli/core/simulation.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"

/// Small scenes for the tests of heat, made without the scene folder.
namespace lapilli::scenes {

/// Points of spacing h / per_axis at the lattice of the grid wherever inside(x) holds.
template <int Dim, class Inside>
std::unique_ptr<Points> fill(const Grid<Dim>& grid, int per_axis, const Inside& inside) {
  auto points = std::make_unique<Points>(Dim);
  const double spacing = grid.cell_size() / per_axis;
  std::vector<double> positions, volumes;
  Index sites = 1;
  std::array<Index, Dim> count;
  for (int axis = 0; axis < Dim; ++axis) {
    count[axis] = (grid.cells(axis) - 2 * Grid<Dim>::padding) * per_axis;
    sites *= count[axis];
  }
  for (Index site = 0; site < sites; ++site) {
    Vec<Dim> x;
    Index rest = site;
    for (int axis = 0; axis < Dim; ++axis) {
      x[axis] = grid.lower()[axis] + (static_cast<double>(rest % count[axis]) + 0.5) * spacing;
      rest /= count[axis];
    }
    if (inside(x)) {
      positions.insert(positions.end(), x.data(), x.data() + Dim);
      volumes.push_back(std::pow(spacing, Dim));
    }
  }
  points->append(positions, volumes, 0);
  return points;
}

inline HeatBody unit_body(int per_axis, double temperature = 0.0) {
  HeatBody body;
  body.material.density = 1.0;
  body.material.specific_heat = 1.0;
  body.material.conductivity = 1.0;
  body.half_width = 0.5 / per_axis;
  body.temperature = temperature;
  return body;
}

/// One body on a grid with default settings.
template <int Dim>
HeatProblem<Dim> problem_on(const Grid<Dim>& grid, const HeatBody& body) {
  return {grid, ShapeFunction::gimp, {body}, HeatSettings{}, DistanceFunction{}, false};
}

template <int Dim>
Simulation simulate(std::unique_ptr<Points> points, const HeatProblem<Dim>& problem, double step,
                    double end) {
  std::vector<std::unique_ptr<Physics>> physics;
  physics.push_back(make_heat(*points, problem));
  return Simulation(std::move(points), std::move(physics), {end, step});
}

inline std::span<double> field(Simulation& simulation, const std::string& name) {
  for (const Field& f : simulation.fields()) {
    if (f.name == name) {
      return f.values;
    }
  }
  throw std::invalid_argument("no field " + name);
}

}  // namespace lapilli::scenes
