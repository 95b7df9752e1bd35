#include <catch2/catch.hpp>

#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

/// The ring of radii 1 and 5 at h = 0.2: heated inside, convection outside.
Simulation ring(const std::function<void(HeatSettings&)>& change, double step, double end) {
  const double h = 0.2;
  HeatProblem<2> problem = scenes::problem_on(
      Grid<2>(Vec<2>::Constant(-6.0), Vec<2>::Constant(6.0), h), scenes::unit_body(2));
  Flux inside;
  inside.value = 1.0;
  inside.region = Disk{{0.0, 0.0}, 3.0};
  problem.settings.boundaries = {inside, scenes::convection(1.0, 0.5)};
  problem.distance = [](const Vec3& x) {
    const double r = x.head<2>().norm();
    return std::max(1.0 - r, r - 5.0);
  };
  change(problem.settings);
  auto points = scenes::scatter<2>(Vec<2>::Zero(), 5.0, 0.5 * h, {}, [](const Vec<2>& y) {
    return y.norm() > 1.0 && y.norm() < 5.0;
  });
  return scenes::simulate(std::move(points), problem, step, end);
}

std::vector<double> temperatures(Simulation simulation, double end) {
  simulation.run_until(end);
  CHECK(std::abs(simulation.balances().front().residual()) <= 1e-12);
  const auto values = scenes::field(simulation, "temperature");
  return {values.begin(), values.end()};
}

void implicit(HeatSettings& settings) {
  settings.time_integration = TimeIntegration::implicit_theta;
}

// The bar: 1e-4 of the temperatures of about 1. Explicit steps of h^2/80 err by some 5e-5.
TEST_CASE("Implicit steps agree with explicit ones") {
  const double end = 1.0;
  const std::vector<double> slow = temperatures(ring([](auto&) {}, 0.0005, end), end);
  const std::vector<double> quick = temperatures(ring(implicit, 0.02, end), end);
  const double worst = scenes::largest_difference(slow, quick);
  INFO("largest difference " << worst);
  CHECK(worst <= 1e-4);
}

TEST_CASE("Conjugate gradients and the factor agree") {
  const auto with = [](HeatSolver solver) {
    return [=](HeatSettings& settings) {
      implicit(settings);
      settings.solver = solver;
    };
  };
  const double end = 1.0;
  const double worst = scenes::largest_difference(
      temperatures(ring(with(HeatSolver::direct), 0.1, end), end),
      temperatures(ring(with(HeatSolver::conjugate_gradient), 0.1, end), end));
  INFO("largest difference " << worst);
  CHECK(worst <= 1e-10);
}

TEST_CASE("Implicit steps a hundred times larger, and far larger ones, are stable") {
  for (const double theta : {0.5, 1.0}) {
    for (const double step : {1.0, 100.0}) {
      Simulation simulation = ring(
          [&](HeatSettings& settings) {
            implicit(settings);
            settings.theta = theta;
          },
          step, 1e9);
      scenes::Range range;
      for (int k = 0; k < 40; ++k) {
        simulation.step();
        range.include(scenes::field(simulation, "temperature"));
      }
      INFO("theta " << theta << ", step " << step << ": " << range.low << " to " << range.high);
      // Steady: flux 1 through the radius 1, T = 0.5 + (1/5) + ln(5/r), at most 2.31 inside.
      CHECK(range.beyond(0.0, 2.5) <= 0.02);
      CHECK(simulation.next_step_size() == step);
    }
  }
}

TEST_CASE("Implicit steps need nodal temperatures and points at rest") {
  CHECK_THROWS_WITH(ring(
                        [](HeatSettings& settings) {
                          implicit(settings);
                          settings.transfer = HeatTransfer::flip;
                        },
                        0.1, 1.0),
                    Catch::Contains("implicit") && Catch::Contains("flip"));
}

}  // namespace
}  // namespace lapilli
