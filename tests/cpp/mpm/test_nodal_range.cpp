#include <catch2/catch.hpp>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/geometry/random.hpp"
#include "lapilli/mpm/heat/cut_cell_heat.hpp"
#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

/// A body at 0 of unit properties in surroundings at 1, or the other way round, under a law drawn
/// at random, at rest anywhere on a grid of unit cells.
template <int Dim>
Simulation drawn(int seed, std::string& about) {
  Random random(static_cast<std::uint64_t>(seed));
  const auto uniform = [&](double low, double high) { return random.uniform(low, high); };
  const double edge = 7.0;
  std::vector<double> lower, upper, middle;
  for (int axis = 0; axis < Dim; ++axis) {
    const double cut = std::pow(10.0, uniform(-12.0, 0.0));
    middle.push_back(uniform(-0.5, 0.5));
    lower.push_back(-2.0 - cut);
    upper.push_back(lower.back() + uniform(3.0, 6.0));
  }
  Shape shape = Box{lower, upper};
  if constexpr (Dim == 2) {
    if (seed % 3 == 0) {
      shape = Disk{middle, uniform(2.0, 5.0)};
    } else if (seed % 3 == 1) {
      Rotated turned;
      turned.shape = shape;
      turned.degrees = uniform(0.0, 90.0);
      shape = turned;
    }
  } else if constexpr (Dim == 3) {
    if (seed % 2 == 0) {
      shape = Sphere{middle, uniform(2.0, 3.5)};
    }
  }
  HeatBody body = scenes::unit_body(Dim);
  const bool warms = seed % 2 == 0;
  body.temperature = warms ? 0.0 : 1.0;
  body.shape = shape;
  HeatSettings settings;
  const double biot = std::pow(10.0, uniform(-8.0, 8.0));
  if (seed % 4 == 3) {
    PrescribedTemperature held;
    held.value = warms ? 1.0 : 0.0;
    settings.boundaries = {held};
  } else if (seed % 4 == 2) {
    Radiation law;
    law.ambient = warms ? 1.0 : 0.0;
    law.stefan_boltzmann = biot;
    settings.boundaries = {law};
  } else {
    settings.boundaries = {scenes::convection(biot, warms ? 1.0 : 0.0)};
  }
  const bool implicit = seed % 5 == 4;
  if (implicit) {
    settings.time_integration = TimeIntegration::implicit_theta;
  }
  about = message("seed ", seed, ", ", Dim, "D, Biot ", biot, implicit ? ", theta" : "");
  const Grid<Dim> grid(Vec<Dim>::Constant(-edge), Vec<Dim>::Constant(edge), 1.0);
  Lattice lattice;
  lattice.lower.template head<Dim>() = grid.lower();
  auto points = std::make_unique<Points>(Dim);
  const FilledPoints filled = fill(shape, lattice, {}, Dim);
  points->append(filled.position, filled.volume, 0);
  HeatProblem<Dim> problem{grid, ShapeFunction::gimp, {body}, settings, {}, false};
  return scenes::simulate<Dim>(std::move(points), problem, implicit ? uniform(0.05, 2.0) : 0.0,
                               1e9);
}

double stray(const Simulation& simulation) {
  for (const auto& [name, value] : simulation.physics().front()->diagnostics()) {
    if (name == "nodal_stray") {
      return value;
    }
  }
  FAIL("no diagnostic nodal_stray");
  return 0.0;
}

template <int Dim>
void nodes_stay_in_range(int first, int last, int steps, double of_implicit = 1e-9) {
  for (int seed = first; seed < last; ++seed) {
    std::string about;
    Simulation simulation = drawn<Dim>(seed, about);
    double most = 0.0;
    for (int step = 0; step < steps; ++step) {
      simulation.step();
      most = std::max(most, stray(simulation));
    }
    INFO(about);
    CHECK(most <= (about.find("theta") == std::string::npos ? 1e-9 : of_implicit));
    // Against the heat of the whole range: a body that hardly exchanges turns next to nothing over.
    const Balance balance = simulation.balances().front();
    double gap = balance.stored - balance.initial;
    for (const auto& entry : balance.entries) {
      gap -= entry.in;
    }
    CHECK(std::abs(gap) <= 1e-12 * std::max(std::abs(balance.stored), std::abs(balance.initial)));
  }
}

TEST_CASE("Nodes inside drawn bodies stay between start and surroundings") {
  nodes_stay_in_range<1>(0, 20, 40);
  nodes_stay_in_range<2>(0, 40, 30);
  nodes_stay_in_range<3>(0, 6, 12);
}

TEST_CASE("Nodes inside many drawn bodies stay between start and surroundings", "[.][slow]") {
  // Of implicit steps some twenty scenes of a thousand find no neighbour with room: 7.3e-5 at most.
  nodes_stay_in_range<1>(20, 400, 80, 1e-4);
  nodes_stay_in_range<2>(40, 600, 60, 1e-4);
  nodes_stay_in_range<3>(6, 40, 30, 1e-4);
}

}  // namespace
}  // namespace lapilli
