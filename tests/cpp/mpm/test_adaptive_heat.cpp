// Heat that chooses its own steps: the same bytes when resumed in either phase, for any threads.
#include <catch2/catch.hpp>
#include <cmath>

#include "lapilli/core/parallel.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/mpm/heat/adaptive_steps.hpp"
#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

Simulation start() {
  const Grid<2> grid(Vec<2>::Constant(-8.0), Vec<2>::Constant(8.0), 1.0);
  Lattice lattice;
  lattice.lower.head<2>() = grid.lower();
  HeatBody disk = scenes::unit_body(2);
  disk.shape = Disk{{0.1, 0.2}, 5.0};
  disk.temperature = 300.0;
  const FilledPoints filled = fill(*disk.shape, lattice, {}, 2);
  auto points = std::make_unique<Points>(2);
  points->append(filled.position, filled.volume, 0);
  Radiation law;
  law.ambient = Table{{0.0, 3000.0, 3000.0, 9000.0}, {500.0, 500.0, 900.0, 400.0}};
  HeatSettings settings;
  settings.boundaries = {law};
  settings.time_integration = TimeIntegration::automatic;
  settings.tolerance = 1e-2;
  HeatProblem<2> problem{grid, ShapeFunction::gimp, {disk}, settings, {}, false};
  return scenes::simulate<2>(std::move(points), problem, 0.0, 9000.0);
}

double long_steps(const Simulation& simulation) {
  double sum = 0.0;
  for (const auto& [name, value] : simulation.physics().front()->diagnostics()) {
    sum += name == "implicit_steps" || name == "staged_steps" ? value : 0.0;
  }
  return sum;
}

TEST_CASE("A run that chooses its steps goes on with the same bytes") {
  // In the explicit phase, between two long steps, right before and after a jump, on a ramp.
  for (const double pause : {100.0, 2500.0, 3000.0, 3010.0, 5000.0}) {
    Simulation whole = start();
    whole.run_until(pause);
    Archive archive;
    whole.save(archive);
    whole.run_until(pause + 2000.0);
    Simulation resumed = start();
    resumed.load(archive);
    resumed.run_until(pause + 2000.0);
    INFO("paused at " << pause);
    CHECK(long_steps(whole) > 0.0);
    CHECK(long_steps(whole) == long_steps(resumed));
    CHECK(whole.step_index() == resumed.step_index());
    CHECK(scenes::largest_difference(scenes::by_id(whole, "temperature"),
                                     scenes::by_id(resumed, "temperature")) == 0.0);
  }
}

TEST_CASE("Implicit steps come when they pay, follow their error and leave for jumps") {
  AdaptiveSteps steps(1e-4, 0.1, 100.0);
  const double never = 1e300;
  CHECK_FALSE(steps.choose(50.0, 0.0, never));   // 0.08 x 50 < 100 x 0.1
  CHECK_FALSE(steps.choose(200.0, 0.0, 205.0));  // a table has its next entry too soon
  CHECK(steps.choose(200.0, 0.0, never));
  CHECK(steps.kind() == SteppingKind::implicit);
  CHECK(steps.size() == Approx(16.0));
  steps.follow(16.0, 0.2e-4);  // as large as allowed: a little shorter
  CHECK(steps.size() == Approx(0.9 * 16.0));
  steps.follow(steps.size(), 1e-9);  // at most twice as long
  CHECK(steps.size() == Approx(1.8 * 16.0));
  steps.follow(2.0, 1e-12);  // one cut short says nothing against long ones
  CHECK(steps.size() == Approx(1.8 * 16.0));
  CHECK(steps.shorter(16.0, 1.0) == Approx(1.6));
  CHECK(steps.accepts(16.0, 0.4e-4));
  CHECK_FALSE(steps.accepts(16.0, 0.6e-4));
  CHECK(steps.choose(300.0, 290.0, never));  // a jump
  CHECK_FALSE(steps.are_long());
  CHECK_FALSE(steps.choose(350.0, 290.0, never));  // counts from the jump
}

TEST_CASE("Steps in stages come before implicit ones and give way where they would be many") {
  const double never = 1e300;
  AdaptiveSteps steps(1e-4, 0.1, 400.0);
  steps.allow_stages(12.0);  // 2 over the limit of an explicit step, of which 0.1 is 0.6
  CHECK_FALSE(steps.choose(1.0, 0.0, never));   // too soon
  CHECK_FALSE(steps.choose(50.0, 0.0, never));  // 40 steps for 15: not a quarter
  CHECK(steps.choose(200.0, 0.0, never));
  CHECK(steps.kind() == SteppingKind::stages);
  CHECK(steps.size() == Approx(0.15));  // growing from explicit ones
  CHECK(steps.stages(4.0) == 9);
  for (int k = 0; k < 5; ++k) {
    steps.follow(steps.size(), -1.0);  // whose error says nothing
  }
  CHECK(steps.size() == Approx(0.4));
  CHECK(steps.accepts(0.4, 1.0));  // nothing shorter is better
  CHECK_FALSE(steps.accepts(0.8, 1.0));
  for (int k = 0; k < 30; ++k) {
    steps.follow(steps.size(), 0.0);
  }
  CHECK(steps.choose(210.0, 0.0, never));
  CHECK(steps.kind() == SteppingKind::implicit);
  StepsAhead ahead;
  steps.count(210.0, 1e9, 0.0, ahead);
  CHECK(ahead.number < 300.0);
  CHECK(ahead.cost < 400.0 * 300.0);
  CHECK(steps.choose(211.0, 210.5, never));  // a jump
  CHECK_FALSE(steps.are_long());
}

TEST_CASE("What is ahead is counted") {
  AdaptiveSteps steps(1e-4, 0.1, 400.0);
  StepsAhead all;
  steps.count(0.0, 100.0, 0.0, all);  // none pays: 8 at most, of 80 explicit steps
  CHECK(all.number == Approx(1000.0).epsilon(0.02));
  CHECK(all.cost == all.number);
  StepsAhead longer;
  steps.count(0.0, 1e6, 0.0, longer);
  // Explicit until .08 t = 40 s, then by 8 % each.
  CHECK(longer.number == Approx(5000.0 + std::log(1e6 / 500.0) / std::log(1.08)).epsilon(0.05));
}

TEST_CASE("No implicit step is longer than what changes asks for") {
  const double never = 1e300;
  AdaptiveSteps steps(1e-4, 0.1, 100.0);
  steps.bound(12.0);
  CHECK(steps.choose(1e4, 0.0, never));
  CHECK(steps.size() == Approx(12.0));
  steps.follow(12.0, 1e-9);
  CHECK(steps.size() == Approx(12.0));
  AdaptiveSteps explicit_ones(1e-4, 0.1, 100.0);
  explicit_ones.bound(9.0);
  CHECK_FALSE(explicit_ones.choose(1e6, 0.0, never));
}

}  // namespace
}  // namespace lapilli
