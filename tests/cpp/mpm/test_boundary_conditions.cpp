#include <catch2/catch.hpp>
#include <numeric>

#include "lapilli/geometry/prescribed_motion.hpp"
#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

using scenes::Trial;

Flux flux(Value value, std::optional<Shape> region = {}) {
  Flux law;
  law.value = std::move(value);
  law.region = std::move(region);
  return law;
}

HalfSpace left_of(double x) { return {{x, 0.0}, {1.0, 0.0}}; }

double diagnostic(const Simulation& simulation, const std::string& name) {
  for (const auto& [key, value] : simulation.physics().back()->diagnostics()) {
    if (key == name) {
      return value;
    }
  }
  throw std::invalid_argument(name);
}

double area(const std::vector<HeatBoundary>& laws) {
  Trial<2> trial;
  trial.settings.boundaries = laws;
  return diagnostic(trial.start(1.0), "surface_area");
}

TEST_CASE("Regions share the whole surface, the first match winning") {
  const double whole = area({flux(1.0)});
  CHECK(whole == Approx(48.0).epsilon(0.01));
  CHECK(area({flux(1.0, left_of(0.3)), flux(2.0)}) == Approx(whole).epsilon(1e-13));
  CHECK(area({flux(1.0, left_of(-2.0)), flux(1.0, left_of(2.0)), scenes::convection(1.0, 0.0)}) ==
        Approx(whole).epsilon(0.01));  // convection counts areas without negatives

  // Heat of one step tells which law a place got: the second law may only have what the first left.
  Trial<2> trial;
  trial.settings.boundaries = {flux(1.0, left_of(0.25)), flux(10.0, left_of(3.25)), flux(100.0)};
  Simulation simulation = trial.start(1.0, 0.1);
  simulation.step();
  const auto entries = simulation.balances().front().entries;
  REQUIRE(entries.size() == 3);
  const double first = entries[0].in / 0.1, second = entries[1].in / 1.0;
  const double third = entries[2].in / 10.0;
  CHECK(first + second + third == Approx(whole).epsilon(1e-12));
  // Left of 0.25, with a slack of a quarter cell: one side of 12 and two of 6 and a half node.
  CHECK(first == Approx(24.0).margin(1.5));
  CHECK(second == Approx(6.0).margin(1.1));
  CHECK(third == Approx(18.0).margin(1.5));
}

TEST_CASE("Laws that share a node keep the balance closed and act as one where they are alike") {
  for (const bool implicit : {false, true}) {
    for (const HeatTransfer transfer : {HeatTransfer::nodal, HeatTransfer::affine}) {
      if (implicit && transfer != HeatTransfer::nodal) {
        continue;  // implicit steps need nodal temperatures
      }
      Trial<2> trial;
      trial.layout.angle = 20.0;
      trial.settings.transfer = transfer;
      if (implicit) {
        trial.settings.time_integration = TimeIntegration::implicit_theta;
      }
      Convection left = scenes::convection(0.7, 1.0);
      left.region = left_of(0.3);
      trial.settings.boundaries = {scenes::convection(0.7, 1.0)};
      const std::vector<HeatBoundary> one = trial.settings.boundaries;
      double difference[2];
      for (const int part : {0, 1}) {
        const double step = part == 0 ? 0.05 : 0.0125;
        trial.settings.boundaries = one;
        Simulation whole = trial.start(4.0, step);
        whole.run_until(4.0);
        trial.settings.boundaries = {left, one.front()};
        Simulation parted = trial.start(4.0, step);
        parted.run_until(4.0);
        CHECK(std::abs(parted.balances().front().residual()) < 1e-12);
        difference[part] = scenes::largest_difference(scenes::by_id(whole, "temperature"),
                                                      scenes::by_id(parted, "temperature"));
      }
      CAPTURE(name_of(transfer), difference[0], difference[1]);
      if (implicit) {  // all laws at once
        CHECK(difference[0] < 1e-12);
      } else {  // laws one after the other: an error of the step, at shared nodes
        CHECK(difference[0] < 2e-3);
        CHECK(difference[1] < 0.3 * difference[0]);
      }
    }
  }
}

TEST_CASE("A region that selects no surface is refused by name") {
  Trial<2> trial;
  trial.settings.boundaries = {flux(1.0), flux(1.0, left_of(0.0))};
  CHECK_THROWS_WITH(trial.start(1.0),
                    Catch::Contains("heat.boundaries.1") && Catch::Contains("selects no surface"));
  Flux far = flux(1.0, left_of(-40.0));
  far.name = "west";
  trial.settings.boundaries = {far};
  CHECK_THROWS_WITH(trial.start(1.0), Catch::Contains("west"));
  trial.moving = true;
  CHECK_THROWS_WITH(trial.start(1.0), Catch::Contains("west"));
}

TEST_CASE("Laws see the surface, the temperature there and the time") {
  for (const HeatTransfer transfer : {HeatTransfer::nodal, HeatTransfer::affine}) {
    double farthest = 0.0, latest = -1.0, warmest = 0.0;
    int calls = 0;
    Trial<2> trial;
    trial.round = true;
    trial.settings.transfer = transfer;
    trial.body.temperature = 7.0;
    trial.settings.boundaries = {
        flux(ArrayFunction([&](std::span<const Vec3> x, std::span<const double> state, double time,
                               std::span<double> values) {
          for (std::size_t k = 0; k < values.size(); ++k) {
            farthest = std::max(farthest, std::abs(x[k].norm() - 6.0));
            warmest = std::max(warmest, state[k]);
            values[k] = 0.5;
          }
          latest = std::max(latest, time);
          ++calls;
        }))};
    Simulation simulation = trial.start(1.0, 0.1);
    simulation.run_until(0.3);
    INFO(name_of(transfer));
    CHECK(calls >= 3);
    CHECK(latest == Approx(0.25));  // the middle of the last step
    CHECK(warmest >= 7.0);
    CHECK(farthest < 1.0);  // nodes two layers deep are projected to within a cell
    const double in = simulation.balances().front().entries.front().in;
    CHECK(in == Approx(0.5 * 0.3 * 12.0 * std::acos(-1.0)).epsilon(0.02));
  }
}

TEST_CASE("A table is followed in time") {
  Trial<2> trial;
  trial.settings.boundaries = {flux(Table{{0.0, 0.2, 0.4}, {0.0, 1.0, 0.0}})};
  Simulation simulation = trial.start(1.0, 0.1);
  simulation.run_until(0.6);
  // The mean over every step, .25, .75, .75, .25, 0, 0.
  const double whole = diagnostic(simulation, "surface_area");
  CHECK(simulation.balances().front().entries.front().in == Approx(0.2 * whole).epsilon(1e-12));
}

TEST_CASE("A source heats an insulated body evenly, at the rate over its capacity") {
  for (const HeatTransfer transfer : {HeatTransfer::nodal, HeatTransfer::flip, HeatTransfer::pic,
                                      HeatTransfer::affine, HeatTransfer::tpic}) {
    Trial<2> trial;
    trial.layout.angle = 20.0;
    trial.settings.transfer = transfer;
    trial.body.source = 3.0;
    trial.body.material.specific_heat = 2.0;
    Simulation simulation = trial.start(1.0);
    simulation.run_until(2.0);
    INFO(name_of(transfer));
    for (const double value : scenes::field(simulation, "temperature")) {
      REQUIRE(value == Approx(3.0).epsilon(1e-11));
    }
    CHECK(simulation.balances().front().entries.back().in == Approx(3.0 * 144.0 * 2.0));
  }
}

std::vector<HeatBoundary> law_of(const std::string& kind) {
  if (kind == "flux") {
    return {flux(-0.3)};
  }
  if (kind == "stiff convection") {
    return {scenes::convection(1e6, 350.0)};
  }
  if (kind == "convection") {
    return {scenes::convection(0.7, 350.0)};
  }
  if (kind == "radiation") {
    Radiation law;
    law.ambient = 900.0;
    return {law};
  }
  PrescribedTemperature law;
  law.value = 280.0;
  return {law};
}

// Heat in, stored and out are the same sums taken apart: what differs is rounding.
TEST_CASE("The balance closes for every transfer and law") {
  const std::string kind = GENERATE(as<std::string>{}, "flux", "convection", "stiff convection",
                                    "radiation", "temperature");
  struct Way {
    HeatTransfer transfer;
    bool moving;
    TimeIntegration stepping;
    FluxMethod method;
  };
  const auto here = FluxMethod::virtual_flux;
  const auto steps = TimeIntegration::explicit_euler;
  for (const Way& way :
       {Way{HeatTransfer::nodal, false, steps, here}, Way{HeatTransfer::flip, false, steps, here},
        Way{HeatTransfer::pic, false, steps, here}, Way{HeatTransfer::affine, false, steps, here},
        Way{HeatTransfer::affine, true, steps, here}, Way{HeatTransfer::flip, true, steps, here},
        Way{HeatTransfer::pic, true, steps, here}, Way{HeatTransfer::tpic, true, steps, here},
        Way{HeatTransfer::nodal, false, TimeIntegration::implicit_theta, here},
        Way{HeatTransfer::flip, true, steps, FluxMethod::paper},
        Way{HeatTransfer::nodal, false, steps, FluxMethod::node},
        Way{HeatTransfer::flip, true, steps, FluxMethod::particle}}) {
    if (kind == "temperature" && way.method == FluxMethod::particle) {
      continue;
    }
    Trial<2> trial;
    trial.moving = way.moving;
    trial.settings.transfer = way.transfer;
    trial.settings.time_integration = way.stepping;
    trial.settings.method = way.method;
    trial.settings.boundaries = law_of(kind);
    trial.body.temperature = 300.0;
    trial.body.source = 0.01;
    auto points = trial.points();
    Rotation turning;
    turning.revolutions_per_second = 0.01;
    std::vector<std::unique_ptr<Physics>> physics;
    if (way.moving) {
      physics.push_back(std::make_unique<PrescribedMotion<2>>(
          *points, std::vector<std::optional<Motion>>{Motion(turning)}));
    }
    physics.push_back(make_heat(*points, trial.problem()));
    const bool implicit = way.stepping == TimeIntegration::implicit_theta;
    const bool explicit_law = way.method == FluxMethod::particle && kind == "stiff convection";
    Simulation simulation(std::move(points), std::move(physics),
                          {1e9, implicit       ? 5.0
                                : explicit_law ? 1e-8
                                               : 0.0});
    for (int k = 0; k < 50; ++k) {
      simulation.step(1e9, false);
    }
    const Balance balance = simulation.balances().front();
    INFO(kind << ", " << name_of(way.transfer) << ", " << name_of(way.method) << ", "
              << name_of(way.stepping) << (way.moving ? ", moving" : ", at rest") << ": residual "
              << balance.residual() << ", taken in " << balance.supplied());
    CHECK(std::abs(balance.residual()) <= 1e-12);
    CHECK(balance.turnover() > 0.0);
  }
}

}  // namespace
}  // namespace lapilli
