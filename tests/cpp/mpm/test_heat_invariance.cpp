#include <catch2/catch.hpp>

#include "lapilli/core/archive.hpp"
#include "lapilli/geometry/prescribed_motion.hpp"
#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

using scenes::Trial;

const std::vector<HeatTransfer> transfers{HeatTransfer::nodal, HeatTransfer::affine,
                                          HeatTransfer::flip, HeatTransfer::pic,
                                          HeatTransfer::tpic};

/// A square with a hot and a convective side and a source, moving or at rest.
Trial<2> scene(HeatTransfer transfer, bool moving) {
  Trial<2> trial;
  trial.half = 16.0;
  trial.moving = moving;
  trial.settings.transfer = transfer;
  Flux flux;
  flux.value = 1.0;
  flux.region = Box{{-100.0, -100.0}, {0.0, 100.0}};
  trial.settings.boundaries = {flux, scenes::convection(2.0, 3.0)};
  trial.body.source = 0.1;
  trial.body.temperature = ArrayFunction(
      [](std::span<const Vec3> x, std::span<const double>, double, std::span<double> values) {
        for (std::size_t k = 0; k < values.size(); ++k) {
          values[k] = std::cos(0.3 * x[k][0]) + 0.1 * x[k][1];
        }
      });
  return trial;
}

Simulation start(const Trial<2>& trial, std::optional<Motion> motion = {}) {
  auto points = trial.points();
  std::vector<std::unique_ptr<Physics>> physics;
  if (trial.moving) {
    physics.push_back(
        std::make_unique<PrescribedMotion<2>>(*points, std::vector<std::optional<Motion>>{motion}));
  }
  physics.push_back(make_heat(*points, trial.problem()));
  return Simulation(std::move(points), std::move(physics), {1e9, 0.0});
}

Motion turning(double rate) {
  Rotation rotation;
  rotation.revolutions_per_second = rate;
  return rotation;
}

std::vector<double> everything(Simulation& simulation) {
  std::vector<double> all;
  for (const Field& field : simulation.fields()) {
    const auto sorted = scenes::by_id(simulation, field.name);
    all.insert(all.end(), sorted.begin(), sorted.end());
  }
  const Balance balance = simulation.balances().front();
  for (const auto& entry : balance.entries) {
    all.push_back(entry.in);
  }
  all.push_back(balance.stored);
  return all;
}

void run(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) {
    simulation.step(1e9, false);
  }
}

TEST_CASE("Any number of threads gives the same bytes") {
  for (const HeatTransfer transfer : transfers) {
    for (const bool moving : {false, true}) {
      if (moving && transfer == HeatTransfer::nodal) {
        continue;
      }
      std::vector<double> one;
      for (const int threads : {1, 2, 4}) {
        set_thread_count(threads);
        Simulation simulation = start(scene(transfer, moving), turning(0.02));
        run(simulation, 12);
        const std::vector<double> now = everything(simulation);
        one = threads == 1 ? now : one;
        INFO(name_of(transfer) << (moving ? ", moving" : ", at rest"));
        CHECK(now == one);
      }
      set_thread_count(0);
    }
  }
}

TEST_CASE("A resumed run gives the same bytes") {
  for (const HeatTransfer transfer : transfers) {
    for (const bool moving : {false, true}) {
      if (moving && transfer == HeatTransfer::nodal) {
        continue;
      }
      for (const bool looked : {false, true}) {
        Trial<2> trial = scene(transfer, moving);
        trial.half = 6.0;
        Simulation whole = start(trial, turning(0.05));
        run(whole, 9);
        if (looked) {
          whole.fields();
        }
        Archive archive;
        whole.save(archive);
        run(whole, 17);
        Simulation resumed = start(trial, turning(0.05));
        resumed.load(archive);
        run(resumed, 17);
        INFO(name_of(transfer) << (moving ? ", moving" : ", at rest"));
        CHECK(everything(resumed) == everything(whole));
        CHECK(resumed.time() == whole.time());
        CHECK(resumed.step_index() == whole.step_index());
      }
    }
  }
}

// Millimetres, milliseconds and kilojoules: nothing but rounding may change.
TEST_CASE("Other units give the same temperatures") {
  for (const HeatTransfer transfer : transfers) {
    for (const bool radiating : {false, true}) {
      Trial<2> metres;
      metres.h = 0.1;
      metres.half = 5.5;
      metres.layout.angle = 20.0;
      metres.settings.transfer = transfer;
      metres.body.temperature = 300.0;
      Trial<2> millimetres = metres;
      millimetres.h *= 1e3;
      millimetres.body.material.specific_heat = 1e-3 / 1e9;
      millimetres.body.material.conductivity = 1e-3 / 1e3 / 1e3;
      if (radiating) {
        Radiation law;
        law.ambient = 1000.0;
        metres.settings.boundaries = {law};
        law.stefan_boltzmann *= 1e-3 / 1e3 / 1e6;
        millimetres.settings.boundaries = {law};
      } else {
        metres.settings.boundaries = {scenes::convection(5.0, 400.0)};
        millimetres.settings.boundaries = {scenes::convection(5.0 * 1e-3 / 1e3 / 1e6, 400.0)};
      }
      Simulation first = metres.start(1e9), second = millimetres.start(1e9);
      run(first, 40);
      run(second, 40);
      INFO(name_of(transfer) << (radiating ? ", radiation" : ", convection"));
      const double span = radiating ? 700.0 : 100.0;
      CHECK(scenes::largest_difference(scenes::by_id(first, "temperature"),
                                       scenes::by_id(second, "temperature")) <= 1e-10 * span);
    }
  }
}

/// Grid, body and initial field shifted by `cells` cells of size `h`.
std::vector<double> shifted(HeatTransfer transfer, double h, double cells) {
  const Vec<2> by(cells * h, -2.0 * cells * h);
  const Vec<2> edge = Vec<2>::Constant(8.0 * h);
  HeatProblem<2> problem =
      scenes::problem_on(Grid<2>(by - edge, by + edge, h), scenes::unit_body(2));
  problem.settings.transfer = transfer;
  problem.settings.boundaries = {scenes::convection(2.0 / h, 1.0)};
  auto points = scenes::scatter<2>(by, 5.0 * h, 0.5 * h, {}, [](const Vec<2>&) { return true; });
  Simulation simulation = scenes::simulate(std::move(points), problem, 0.0, 1e9);
  run(simulation, 30);
  return scenes::by_id(simulation, "temperature");
}

TEST_CASE("A shift of grid and body changes nothing, to the byte where places are dyadic") {
  for (const HeatTransfer transfer : transfers) {
    INFO(name_of(transfer));
    CHECK(shifted(transfer, 0.25, 5.0) == shifted(transfer, 0.25, 0.0));
    // h = 0.1 is not dyadic: coordinates differ in the last bit.
    CHECK(scenes::largest_difference(shifted(transfer, 0.1, 7.0), shifted(transfer, 0.1, 0.0)) <=
          1e-11);
  }
}

TEST_CASE("Turned by 90 degrees, the same to rounding") {
  for (const HeatTransfer transfer : transfers) {
    for (const bool moving : {false, true}) {
      if (moving && transfer == HeatTransfer::nodal) {
        continue;
      }
      std::vector<double> upright;
      for (const double angle : {0.0, 90.0}) {
        Trial<2> trial;
        trial.half = 5.5;
        trial.moving = moving;
        trial.layout = {angle + 13.0, 0.1};
        trial.settings.transfer = transfer;
        trial.settings.boundaries = {scenes::convection(2.0, 1.0)};
        Simulation simulation = start(trial, turning(0.05));
        run(simulation, 30);
        const std::vector<double> now = scenes::by_id(simulation, "temperature");
        upright = angle == 0.0 ? now : upright;
        INFO(name_of(transfer) << (moving ? ", moving" : ", at rest"));
        CHECK(scenes::largest_difference(now, upright) <= 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace lapilli
