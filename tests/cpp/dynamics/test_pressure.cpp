#include <catch2/catch.hpp>
#include <numbers>

#include "dynamics/fixtures.hpp"

using namespace dynamics_test;

namespace {

/// From zero to `pressure` by a cosine over 0.8 s, in many pieces: hardly a wave is left.
Table smooth_rise(double pressure) {
  Table rise;
  for (int k = 0; k <= 64; ++k) {
    rise.times.push_back(0.8 * k / 64);
    rise.values.push_back(0.5 * pressure * (1.0 - std::cos(std::numbers::pi * k / 64)));
  }
  return rise;
}

/// A disk that does not fit the grid, under a pressure that grows slowly and then stays: RMS error
/// of the in-plane stress deeper than 2 h from the surface, over the pressure.
double pressed_disk(double h, double* gap) {
  const double radius = 1.0, pressure = 1e3;
  Run<2> run(Grid<2>({-1.3, -1.3}, {1.3, 1.3}, h), ShapeFunction::gimp);
  const LinearElastic solid = elastic(1000, 1e6, 0.3);
  DynamicsBody body{solid, 0.25, {}, {}};
  run.problem.settings.boundaries.push_back(Pressure{"", smooth_rise(pressure), {}});
  run.add(body, 2, [=](const Vec<2>& x) { return (x - Vec<2>(0.013, -0.007)).norm() < radius; });
  run.start();
  run.until(1.0);  // some fifteen wave transits to load, as many to rest
  double square = 0.0;
  Index count = 0;
  for (Index row = 0; row < run.points.size(); ++row) {
    if ((run.points.position<2>(row) - Vec<2>(0.013, -0.007)).norm() < radius - 2 * h) {
      const double* s = run.solver->stress().data() + 4 * row;
      square += (std::pow(s[0] + pressure, 2) + std::pow(s[1] + pressure, 2) + 2 * s[3] * s[3]) / 3;
      ++count;
    }
  }
  const Balance energy = run.solver->balances()[0];
  *gap = (energy.stored - energy.initial - energy.supplied()) / run.value("load work");
  return std::sqrt(square / static_cast<double>(count)) / pressure;
}

}  // namespace

TEST_CASE("pressure on a disk that does not fit the grid presses it evenly") {
  double gap;
  const double error = pressed_disk(0.1, &gap);
  CAPTURE(error, gap);
  CHECK(error < 0.03);
  CHECK(std::abs(gap) < 0.01);
}

TEST_CASE("pressure on a disk on finer grids", "[.slow]") {
  // An even pressure balances its stress at every node whatever the grid; what is left are waves.
  for (double h : {0.1, 0.05, 0.025}) {
    double gap;
    const double error = pressed_disk(h, &gap);
    CAPTURE(h, error, gap);
    CHECK(error < 0.003);
    CHECK(std::abs(gap) < 0.01);
  }
}
