#include "lapilli/mpm/heat/cut_cell_heat.hpp"

#include <catch2/catch.hpp>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/fill.hpp"
#include "mpm/radial_reference.hpp"
#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

using scenes::convection;

/// Bodies at rest, filled on the lattice of a grid of unit cells from -edge to edge.
template <int Dim>
struct Scene {
  double edge = 8.0;
  std::vector<HeatBody> bodies;
  HeatSettings settings;
  ShapeFunction function = ShapeFunction::gimp;

  void add(Shape shape, const Value& temperature = 0.0, double conductivity = 1.0) {
    HeatBody body = scenes::unit_body(2);
    body.temperature = temperature;
    body.material.conductivity = conductivity;
    body.shape = std::move(shape);
    bodies.push_back(body);
  }

  Simulation start(double end, double step = 0.0) const {
    const Grid<Dim> grid(Vec<Dim>::Constant(-edge), Vec<Dim>::Constant(edge), 1.0);
    Lattice lattice;
    lattice.lower.template head<Dim>() = grid.lower();
    auto points = std::make_unique<Points>(Dim);
    int number = 0;
    for (const HeatBody& body : bodies) {
      const FilledPoints filled = fill(*body.shape, lattice, {}, Dim);
      points->append(filled.position, filled.volume, number++);
    }
    HeatProblem<Dim> problem{grid, function, bodies, settings, {}, false};
    return scenes::simulate<Dim>(std::move(points), problem, step, end);
  }
};

PrescribedTemperature held(double value) {
  PrescribedTemperature law;
  law.value = value;
  return law;
}

void theta(HeatSettings& settings) { settings.time_integration = TimeIntegration::implicit_theta; }

double heat_taken(const Simulation& simulation) {
  const Balance balance = simulation.balances().front();
  CHECK(std::abs(balance.residual()) <= 1e-12);
  return balance.stored - balance.initial;
}

double diagnostic(const Simulation& simulation, const std::string& name) {
  for (const auto& [known, value] : simulation.physics().front()->diagnostics()) {
    if (known == name) {
      return value;
    }
  }
  FAIL("no diagnostic " << name);
  return 0.0;
}

TEST_CASE("A disk takes up its heat at any strength of exchange") {
  const double radius = 10.0, end = 5.0;  // Fourier number 0.05
  for (const double biot : {0.1, 1.0, 10.0, 100.0, 1000.0, 1e9}) {
    const scenes::RadialReference exact(0.0, radius, {}, {biot / radius, 1.0}, end);
    double reference = 0.0;
    for (int k = 0; k < 4000; ++k) {
      const double r = (k + 0.5) * radius / 4000;
      reference += 2.0 * M_PI * r * exact(r) * radius / 4000;
    }
    for (const bool implicit : {false, true}) {
      Scene<2> scene;
      scene.edge = 13.0;
      scene.add(Disk{{0.13, 0.21}, radius});
      scene.settings.boundaries = {biot < 1e6 ? HeatBoundary(convection(biot / radius, 1.0))
                                              : HeatBoundary(held(1.0))};
      if (implicit) {
        theta(scene.settings);
      }
      Simulation simulation = scene.start(end, implicit ? end / 60 : 0.0);
      simulation.run_until(end);
      const double found = heat_taken(simulation);
      INFO("Biot " << biot << (implicit ? ", theta: " : ", explicit: ") << found / reference - 1);
      // At most 0.4 and 1.36 % (held, at the automatic step).
      CHECK(found == Approx(reference).epsilon(biot <= 1.0 ? 0.005 : 0.015));
      CHECK(diagnostic(simulation, "free_surface_area") == Approx(2 * M_PI * radius).epsilon(1e-3));
    }
  }
}

TEST_CASE("Heat does not depend on where a body lies or how it is turned") {
  const Shape wedge = Polygon{{{-4, -2}, {4, -2}, {4, 2}, {0, 2}, {0, 0}, {-4, 0}}};
  for (const HeatBoundary& law : {HeatBoundary(convection(5.0, 1.0)), HeatBoundary(held(1.0))}) {
    scenes::Range range;
    for (const double angle : {0.0, 17.0, 45.0, 120.0}) {
      Rotated turned;
      turned.shape = wedge;
      turned.degrees = angle;
      Translated moved;
      moved.shape = Shape(turned);
      moved.by = {0.01 * angle, 0.37};
      Scene<2> scene;
      scene.add(moved);
      scene.settings.boundaries = {law};
      Simulation simulation = scene.start(0.8);
      simulation.run_until(0.8);
      const double taken = heat_taken(simulation);
      range.include(std::span(&taken, 1));
    }
    INFO("heat " << range.low << " to " << range.high);
    CHECK(range.high / range.low - 1.0 <= 0.02);
  }
}

TEST_CASE("Bodies touch where they do, and nowhere else") {
  const auto exchanged = [](double gap) {
    Scene<2> scene;
    scene.add(Box{{-4.0, -2.3}, {0.2, 2.1}}, 1.0);
    scene.add(Box{{0.2 + gap, -2.3}, {4.0, 2.1}}, 0.0);
    scene.settings.boundaries = {convection(0.0, 0.0)};
    Simulation simulation = scene.start(4.0);
    simulation.run_until(4.0);
    CHECK(std::abs(heat_taken(simulation)) <= 1e-12);
    const double area = 2 * (8.0 - gap + 2 * 4.4) - (gap == 0.0 ? 2 * 4.4 : 0.0);
    CHECK(diagnostic(simulation, "surface_area") == Approx(area).epsilon(1e-6));
    double right = 0.0;
    const auto values = scenes::field(simulation, "temperature");
    for (Index row = 0; row < simulation.points().size(); ++row) {
      right += simulation.points().body()[row] == 1 ? values[row] : 0.0;
    }
    return right;
  };
  CHECK(exchanged(0.0) > 1.0);
  CHECK(exchanged(0.1) == 0.0);
  CHECK(exchanged(1.0) == 0.0);
}

TEST_CASE("Radiation never passes its surroundings, however cold the body starts") {
  for (const bool implicit : {false, true}) {
    Scene<2> scene;
    scene.add(Box{{-3.1, -2.7}, {3.0, 2.9}}, 300.0, 1e-3);
    Radiation law;
    law.ambient = 3000.0;
    scene.settings.boundaries = {law};
    if (implicit) {
      theta(scene.settings);
      scene.settings.theta = 1.0;
    }
    Simulation simulation = scene.start(1e9, implicit ? 50.0 : 0.0);
    scenes::Range range;
    for (int k = 0; k < 40; ++k) {
      simulation.step();
      range.include(scenes::field(simulation, "temperature"));
    }
    heat_taken(simulation);
    INFO(range.low << " to " << range.high);
    CHECK(range.beyond(300.0, 3000.0) <= 0.02 * 2700.0);
  }
}

TEST_CASE("A pulse shorter than a step counts whole") {
  for (const bool implicit : {false, true}) {
    Scene<2> scene;
    scene.add(Disk{{0.1, 0.2}, 4.0});
    Flux pulse;
    pulse.value = Table{{1.001, 1.001, 1.003, 1.003}, {0.0, 50.0, 50.0, 0.0}};
    scene.settings.boundaries = {pulse};
    if (implicit) {
      theta(scene.settings);
    }
    Simulation simulation = scene.start(2.0, 0.1);
    simulation.run_until(2.0);
    CHECK(heat_taken(simulation) ==
          Approx(0.1 * diagnostic(simulation, "surface_area")).epsilon(1e-9));
  }
}

TEST_CASE("The ambient of a step counts with the coefficient of its time") {
  for (const bool implicit : {false, true}) {
    Scene<2> scene;
    scene.add(Disk{{0.1, 0.2}, 4.0});
    Convection law;
    law.coefficient = Table{{0.1, 0.1}, {1e-3, 0.0}};
    law.ambient = Table{{0.1, 0.1}, {2.0, -1.0}};
    scene.settings.boundaries = {law};
    if (implicit) {
      theta(scene.settings);
    }
    Simulation simulation = scene.start(0.2, 0.2);
    simulation.run_until(0.2);
    CHECK(heat_taken(simulation) ==
          Approx(2e-4 * diagnostic(simulation, "surface_area")).epsilon(1e-3));
  }
}

// Between surroundings at 1 and 0 in a steady state as much goes out as comes in.
TEST_CASE("Every law books its own heat") {
  for (const bool implicit : {false, true}) {
    Scene<2> scene;
    scene.add(Box{{-3.2, -2.1}, {3.1, 2.2}});
    Convection left = convection(0.8, 1.0);
    left.region = Box{{-9.0, -9.0}, {-3.0, 9.0}};
    Convection right = convection(0.8, 0.0);
    right.region = Box{{3.0, -9.0}, {9.0, 9.0}};
    scene.settings.boundaries = {left, right};
    if (implicit) {
      theta(scene.settings);
    }
    Simulation simulation = scene.start(1e4, implicit ? 20.0 : 0.0);
    simulation.run_until(400.0);
    const Balance before = simulation.balances().front();
    simulation.run_until(440.0);
    const Balance after = simulation.balances().front();
    const double in = after.entries[0].in - before.entries[0].in;
    const double out = after.entries[1].in - before.entries[1].in;
    INFO((implicit ? "theta " : "explicit ") << in << " in, " << out << " out");
    // Resistances in series: two of 1/g, and the length; each region takes .1 or .2 of the sides.
    CHECK(in == Approx(40.0 * 4.3 / (2.0 / 0.8 + 6.3)).epsilon(0.03));
    CHECK(out == Approx(-in).epsilon(1e-4));
  }
}

TEST_CASE("Sources, several materials and regions balance in one to three dimensions") {
  const auto balanced = [](auto dimension, Shape left, Shape right, Shape region) {
    constexpr int Dim = decltype(dimension)::value;
    for (const ShapeFunction function :
         {ShapeFunction::linear, ShapeFunction::gimp, ShapeFunction::bspline}) {
      for (const bool implicit : {false, true}) {
        Scene<Dim> scene;
        scene.edge = 5.0;
        scene.function = function;
        scene.add(left, 1.0, 2.0);
        scene.add(right, 3.0, 0.5);
        scene.bodies[0].source = 0.7;
        Convection near = convection(3.0, 2.0);
        near.region = region;
        Flux rest;
        rest.value = -0.3;
        scene.settings.boundaries = {near, rest};
        if (implicit) {
          theta(scene.settings);
        }
        Simulation simulation = scene.start(2.0, implicit ? 0.5 : 0.0);
        simulation.run_until(2.0);
        heat_taken(simulation);
        double source = 0.0;
        const auto balance = simulation.balances().front();
        for (const auto& entry : balance.entries) {
          source += entry.name == "source" ? entry.in : 0.0;
        }
        CHECK(source > 0.0);
      }
    }
  };
  balanced(std::integral_constant<int, 1>{}, Box{{-3.3}, {0.4}}, Box{{0.4}, {2.9}},
           Box{{-9.0}, {0.0}});
  balanced(std::integral_constant<int, 2>{}, Box{{-3.3, -2.0}, {0.4, 2.0}},
           Box{{0.4, -2.0}, {2.9, 2.0}}, Box{{-9.0, -9.0}, {0.0, 9.0}});
  balanced(std::integral_constant<int, 3>{}, Box{{-3.3, -2.0, -1.6}, {0.4, 2.0, 1.5}},
           Box{{0.4, -2.0, -1.6}, {2.9, 2.0, 1.5}}, Box{{-9.0, -9.0, -9.0}, {0.0, 9.0, 9.0}});
}

TEST_CASE("A run that is resumed goes on with the same bytes") {
  for (const bool implicit : {false, true}) {
    Scene<2> scene;
    scene.add(Disk{{0.1, 0.2}, 4.0}, 300.0, 0.1);
    Radiation law;
    law.ambient = Table{{0.0, 50.0}, {300.0, 1500.0}};
    scene.settings.boundaries = {law};
    if (implicit) {
      theta(scene.settings);
      scene.settings.theta = 0.7;
    }
    const double step = implicit ? 2.0 : 0.0;
    Simulation whole = scene.start(60.0, step);
    whole.run_until(20.0);
    Archive archive;
    whole.save(archive);
    whole.run_until(40.0);
    Simulation resumed = scene.start(60.0, step);
    resumed.load(archive);
    resumed.run_until(40.0);
    CHECK(scenes::largest_difference(scenes::by_id(whole, "temperature"),
                                     scenes::by_id(resumed, "temperature")) == 0.0);
  }
}

}  // namespace
}  // namespace lapilli
