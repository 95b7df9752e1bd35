// Every setting shows: its direction, and its amount where that is closed.
#include <catch2/catch.hpp>

#include "cavity.hpp"
#include "lapilli/peridynamics/equation_of_state.hpp"

using namespace lapilli;
using cavity::Case;
using cavity::Layout;

namespace {

Layout square(int rows) {
  Layout layout;
  layout.columns = layout.rows = rows;
  return layout;
}

/// Angular momentum about the middle: positive counter-clockwise.
double turning(const Case& run) {
  double sum = 0.0;
  for (Index i = 0; i < run.points().size(); ++i) {
    if (run.fluid(i)) {
      const double x = run.points().position()[2 * i] - 0.5,
                   y = run.points().position()[2 * i + 1] - 0.5;
      const double* v = run.flow->velocity().data() + 2 * i;
      sum += x * v[1] - y * v[0];
    }
  }
  return sum;
}

double mean_temperature(const Case& run) {
  double sum = 0.0;
  int count = 0;
  for (Index i = 0; i < run.points().size(); ++i) {
    if (run.fluid(i)) {
      sum += run.heat->temperature()[i];
      ++count;
    }
  }
  return sum / count;
}

/// The flow of a box without heat at the walls' rest, with these settings.
Case still(PeridynamicFlowSettings settings, double viscosity) {
  Fluid fluid = cavity::unit_fluid();
  fluid.newtonian = {1.0, viscosity, 1.0, 0.5};
  return Case(square(8), {}, settings, cavity::make_walls(1.0, 0.0), fluid);
}

}  // namespace

TEST_CASE("hot fluid rises with either form of buoyancy") {
  for (const Buoyancy buoyancy : {Buoyancy::reduced, Buoyancy::full}) {
    PeridynamicFlowSettings flow;
    flow.buoyancy = buoyancy;
    Case run = cavity::natural_convection(square(8), 1e4, 0.71, {}, flow);
    run.simulation->run_until(0.01);
    // Hot on the left: up there, down on the right, clockwise.
    REQUIRE(turning(run) < 0.0);
  }
}

TEST_CASE("viscous heat warms the fluid by what it took from the motion") {
  auto walls = cavity::make_walls(0.0, 0.0);
  for (FluidWall& wall : walls) {
    wall.settings.heat = WallHeat::adiabatic;
  }
  walls[3].settings.velocity = {1.0, 0.0};
  PeridynamicHeatSettings heat;
  heat.viscous_dissipation = true;
  PeridynamicFlowSettings flow;
  Case run(square(8), heat, flow, walls);
  double given = 0.0;
  while (run.simulation->time() < 0.02) {
    run.simulation->fields();
    const double before = run.simulation->time();
    double power = 0.0;
    for (Index i = 0; i < run.points().size(); ++i) {
      power += run.fluid(i) ? (*run.flow->dissipation())[i] / 64.0 : 0.0;
    }
    run.simulation->step();
    given += power * (run.simulation->time() - before);
  }
  // Density, specific heat and area are 1: the mean temperature is the heat.
  REQUIRE(mean_temperature(run) > 0.0);
  REQUIRE(mean_temperature(run) == Approx(given).epsilon(0.02));
}

TEST_CASE("a prescribed flux brings in its heat while points pass the wall") {
  auto walls = cavity::make_walls(0.0, 0.0);
  walls[0].settings.heat = WallHeat::flux;
  walls[0].settings.flux = 2.0;
  Fluid fluid = cavity::unit_fluid();
  fluid.newtonian = {1.0, 0.71, 1.0, 0.0};
  PeridynamicFlowSettings flow;
  flow.gravity = {0.0, -7.1e4};
  Case run(square(10), {}, flow, walls, fluid);
  run.simulation->run_until(0.02);
  REQUIRE(turning(run) < 0.0);
  for (int step = 0; step < 40; ++step) {
    run.simulation->step();
    REQUIRE(run.heat->wall_power(0) == Approx(2.0).epsilon(1e-9));
  }
}

TEST_CASE("steps of flow are shares of the way of sound and of shear") {
  const double dx = 1.0 / 8;
  PeridynamicFlowSettings settings;
  settings.sound_speed = 100.0;
  for (const double courant : {0.5, 0.2}) {
    settings.courant = courant;
    const Case run = still(settings, 1e-3);
    REQUIRE(run.flow->step_limit().automatic == Approx(courant * dx / 100.0).epsilon(1e-12));
    REQUIRE(run.flow->step_limit().hard == Approx(dx / 100.0).epsilon(1e-12));
  }
  settings.courant = 0.5;
  for (const double share : {0.25, 0.1}) {
    settings.viscous_step = share;
    const Case run = still(settings, 50.0);
    // dx^2 / (dim nu), in the plane.
    REQUIRE(run.flow->step_limit().hard == Approx(dx * dx / (2 * 50.0)).epsilon(1e-12));
    REQUIRE(run.flow->step_limit().automatic ==
            Approx(share * dx * dx / (2 * 50.0)).epsilon(1e-12));
  }
}

TEST_CASE("steps of heat are a share of dx^2 / (dim alpha)") {
  const double dx = 1.0 / 8;
  for (const double share : {0.25, 0.1}) {
    PeridynamicHeatSettings heat;
    heat.step_factor = share;
    const Case run(square(8), heat);
    REQUIRE(run.heat->step_limit().automatic == Approx(share * dx * dx / 2).epsilon(1e-9));
  }
}

TEST_CASE("the sound speed is the factor times sqrt(g beta dT l), of the range that is given") {
  PeridynamicFlowSettings settings;
  settings.gravity = {0.0, -400.0};
  for (const double factor : {5.0, 2.0}) {
    for (const double range : {0.25, 4.0}) {
      settings.sound_speed_factor = factor;
      settings.temperature_range = range;
      REQUIRE(still(settings, 1e-3).flow->sound_speed() ==
              Approx(factor * std::sqrt(400.0 * range)).epsilon(1e-12));
    }
  }
  settings.length = 9.0;
  REQUIRE(still(settings, 1e-3).flow->sound_speed() ==
          Approx(2.0 * std::sqrt(400.0 * 4.0 * 9.0)).epsilon(1e-12));
}

TEST_CASE("the stiffness exponent bends the pressure, not its slope at rest") {
  for (const double exponent : {1.0, 2.0, 7.0}) {
    const EquationOfState state{2.0, 3.0, exponent};
    REQUIRE(state(2.0) == 0.0);
    REQUIRE((state(2.0 + 1e-6) - state(2.0 - 1e-6)) / 2e-6 == Approx(9.0).epsilon(1e-6));
  }
  REQUIRE(EquationOfState{2.0, 3.0, 1.0}(2.4) == Approx(9.0 * 0.4));
  REQUIRE(EquationOfState{2.0, 3.0, 2.0}(2.4) == Approx(9.0 * (1.44 - 1.0)));
}

TEST_CASE("shifting keeps points apart, density diffusion smooths") {
  double spacing[2], noise[2];
  for (int k = 0; k < 2; ++k) {
    PeridynamicFlowSettings flow;
    flow.shifting = k == 0 ? 0.0 : 0.1;
    Case run = cavity::natural_convection(square(10), 1e4, 0.71, {}, flow);
    run.simulation->run_until(0.02);
    spacing[k] = run.flow->smallest_spacing();
  }
  REQUIRE(spacing[1] > spacing[0]);
  for (int k = 0; k < 2; ++k) {
    PeridynamicFlowSettings flow;
    flow.density_diffusion = k == 0 ? 0.0 : 0.1;
    Case run = cavity::natural_convection(square(10), 1e4, 0.71, {}, flow);
    run.simulation->run_until(0.02);
    noise[k] = run.flow->velocity_noise();
  }
  REQUIRE(noise[1] < noise[0]);
}
