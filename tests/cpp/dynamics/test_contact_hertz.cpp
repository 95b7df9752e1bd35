// Elastic disks pressed against each other.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "dynamics/balls.hpp"

using namespace dynamics_test;

TEST_CASE("two pressed disks follow Hertz", "[.][slow]") {
  // Between two plates, 24 cells in radius, to an approach of R/20. Johnson, Contact Mechanics
  // (1985), section 5.6: from centre to contact F / (pi E*) (2 ln(4 R / a) - 1), a^2 = 4 F R /
  // (pi E*). Of first order in h: off by .055, .029 and .012 at 10, 20 and 40 cells.
  const double radius = 24.0, modulus = young / (1 - poisson * poisson), v = 0.002 * wave;
  Run<2> run(Grid<2>({-52, -28}, {52, 28}, 1.0), ShapeFunction::gimp);
  const Vec<2> offset(0.13, 0.29);
  std::vector<Index> core[2];
  for (int side : {-1, 1}) {
    DynamicsBody body = moving<2>({0, 0}, side < 0 ? "left" : "right");
    body.velocity = [=](const Vec3& x) {
      return Vec3(-v * (x[0] - offset[0]) / (2 * radius), 0, 0);
    };
    const Vec<2> center = offset + Vec<2>(side * radius, 0);
    fill_ball<2>(run, center, radius, body);
    Obstacle plate;
    plate.contact = ObstacleContact::slip;
    plate.shape = HalfSpace{{offset[0] + 2 * side * radius, 0}, {-static_cast<double>(side), 0}};
    plate.velocity = {-side * v, 0};
    run.problem.settings.obstacles.push_back(plate);
    for (Index row = 0; row < run.points.size(); ++row) {
      if ((run.points.position<2>(row) - center).norm() < 1.5) {
        core[(side + 1) / 2].push_back(run.points.id()[row]);
      }
    }
  }
  run.start();
  const auto apart = [&] {
    std::vector<double> x(static_cast<std::size_t>(run.points.size()));
    for (Index row = 0; row < run.points.size(); ++row) {
      x[run.points.id()[row]] = run.points.position()[2 * row];
    }
    double mean[2] = {0, 0};
    for (int side = 0; side < 2; ++side) {
      for (const Index id : core[side]) {
        mean[side] += x[id] / static_cast<double>(core[side].size());
      }
    }
    return mean[1] - mean[0];
  };
  const auto hertz = [&](double approach) {
    double low = 1e-6, high = young * radius;
    for (int k = 0; k < 100; ++k) {
      const double force = 0.5 * (low + high), a2 = 4 * force * radius / std::numbers::pi / modulus;
      const double found =
          force / (std::numbers::pi * modulus) * (std::log(16 * radius * radius / a2) - 1);
      (found < approach ? low : high) = force;
    }
    return low;
  };
  const double start = apart(), end = 0.1 * radius / v;
  run.until(0.7 * end);
  double found = 0.0, exact = 0.0;
  while (run.time < end) {
    run.advance(run.automatic_step());
    found += run.value("left on right force x");
    exact += hertz(0.5 * (start - apart()));
  }
  CAPTURE(found / exact);
  CHECK(found / exact == Approx(1).epsilon(0.03));
}
