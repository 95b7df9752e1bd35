// Obstacles that press round bodies.
#include <algorithm>
#include <catch2/catch.hpp>

#include "dynamics/balls.hpp"

using namespace dynamics_test;

TEST_CASE("plates that press a disk give it no more than their work") {
  // To an approach of R/10, so that points come to the plates column by column and both pass lines
  // of the grid; nodes behind a plate that carry next to nothing were pushed and held at once,
  // which gave 5 to 20 % of the energy and of the force.
  constexpr double radius = 10.0, approach = 0.1 * radius;
  const double v = 0.002 * wave;
  for (double offset : {0.13, 0.63}) {
    Run<2> run(Grid<2>({-14, -14}, {14, 14}, 1.0), ShapeFunction::gimp);
    const Vec<2> center(offset, 0.29);
    fill_ball<2>(run, center, radius, moving<2>({0, 0}, "disk"));
    for (int side : {-1, 1}) {
      Obstacle plate;
      plate.contact = ObstacleContact::slip;
      plate.shape = HalfSpace{{center[0] + side * radius, 0}, {-static_cast<double>(side), 0}};
      plate.velocity = {-side * v, 0};
      run.problem.settings.obstacles.push_back(plate);
    }
    run.start();
    double most = 0.0;
    while (run.time < 0.5 * approach / v) {
      run.advance(run.automatic_step());
      most = std::max(most, run.value("energy gained"));
    }
    CAPTURE(offset, most, run.value("elastic energy"));
    CHECK(most < 0.005 * run.value("elastic energy"));
  }
}
