#include <catch2/catch.hpp>
#include <cstdio>

#include "cavity.hpp"
#include "lapilli/core/simulation.hpp"
#include "lapilli/peridynamics/heat.hpp"

using namespace lapilli;

namespace {

double series(double x, double time) {
  double sum = 1.0 - x;
  for (int n = 1; n < 200; ++n) {
    const double k = n * M_PI;
    sum -= 2.0 / k * std::sin(k * x) * std::exp(-k * k * time);
  }
  return sum;
}

struct Case {
  cavity::Layout layout;
  std::unique_ptr<Simulation> simulation;
  PeridynamicHeat* heat = nullptr;

  explicit Case(const cavity::Layout& of, const PeridynamicHeatSettings& settings) : layout(of) {
    auto points = cavity::make_points(layout);
    auto walls = std::make_shared<WallSurface>(*points, cavity::make_walls(1.0, 0.0),
                                               cavity::box_distance(layout), layout.spacing());
    std::vector<std::unique_ptr<Physics>> physics;
    physics.push_back(std::make_unique<PeridynamicHeat>(*points, walls, settings));
    heat = static_cast<PeridynamicHeat*>(physics.back().get());
    simulation = std::make_unique<Simulation>(std::move(points), std::move(physics),
                                              Simulation::Clock{1.0, 0.0});
  }
  double error() const {
    double difference = 0.0, norm = 0.0;
    const Points& points = simulation->points();
    for (Index i = 0; i < points.size(); ++i) {
      if (points.body()[i] == 0) {
        const double exact = series(points.position()[2 * i], simulation->time());
        difference += std::pow(heat->temperature()[i] - exact, 2);
        norm += exact * exact;
      }
    }
    return std::sqrt(difference / norm);
  }
};

}  // namespace

TEST_CASE("explore conduction", "[.explore]") {
  for (int rows : {20, 40, 80}) {
    for (double offset : {0.5, 1.0}) {
      for (double jitter : {0.0, 0.1}) {
        for (Laplacian laplacian : {Laplacian::compact, Laplacian::corrected}) {
          cavity::Layout layout;
          layout.columns = layout.rows = rows;
          layout.offset = offset;
          layout.jitter = jitter;
          PeridynamicHeatSettings settings;
          settings.laplacian = laplacian;
          Case test(layout, settings);
          std::printf("%d offset %g jitter %g %s:", rows, offset, jitter, name_of(laplacian));
          for (double time : {0.08, 0.16, 0.32}) {
            test.simulation->run_until(time);
            std::printf(" %.4f%%", 100 * test.error());
          }
          std::printf(" imbalance %.2e ledger %.1e\n", test.heat->exchange().imbalance(),
                      test.heat->ledgers()[0].residual());
        }
      }
    }
  }
}

TEST_CASE("explore effective conductivity", "[.explore-steady]") {
  for (double jitter : {0.0, 0.1, 0.2, 0.3}) {
    for (Laplacian laplacian : {Laplacian::compact, Laplacian::corrected}) {
      cavity::Layout layout;
      layout.columns = layout.rows = 20;
      layout.jitter = jitter;
      PeridynamicHeatSettings settings;
      settings.laplacian = laplacian;
      Case test(layout, settings);
      test.simulation->run_until(1.0);
      std::printf("jitter %g %s: flux %.4f %.4f error %.3f%% imbalance %.1e\n", jitter, name_of(laplacian),
                  test.heat->wall_power(0), test.heat->wall_power(1), 100 * test.error(),
                  test.heat->exchange().imbalance());
    }
  }
}
