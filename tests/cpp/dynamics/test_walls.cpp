// What each wall holds and lets go, and points that fly apart.
#include <catch2/catch.hpp>

#include "dynamics/fixtures.hpp"

using namespace dynamics_test;

namespace {

/// A block on the floor of a long grid, thrown along it at 1 m/s and upwards at `rise`; the weight
/// acts from the start, so that it trembles. Half a second.
template <class AddFloor>
std::unique_ptr<Run<2>> thrown(double rise, const AddFloor& add_floor, double stiffness = 1e5) {
  auto run = std::make_unique<Run<2>>(Grid<2>({0, 0}, {3, 2}, 0.1), ShapeFunction::gimp);
  run->add({elastic(1000, stiffness, 0.3), 0.25, [=](const Vec3&) { return Vec3(1, rise, 0); }, {}},
           2, [](const Vec<2>& x) { return x[0] > 0.5 && x[0] < 1.1 && x[1] < 0.3; });
  run->problem.settings.gravity = {0, -10};
  add_floor(*run);
  run->start();
  run->until(0.5);
  return run;
}

constexpr double mass = 1000 * 0.6 * 0.3;  // kg

double momentum_of(const Run<2>& run, int axis) { return run.solver->balances()[1 + axis].stored; }

double given_by_walls(const Run<2>& run, int axis) {
  return run.solver->balances()[1 + axis].entries[1].in;
}

double lowest(const Run<2>& run) {
  double low = 1e300;
  for (Index row = 0; row < run.points.size(); ++row) {
    low = std::min(low, run.points.position<2>(row)[1]);
  }
  return low;
}

}  // namespace

TEST_CASE("a frictional wall slows a block by its coefficient times the force across") {
  for (const double coefficient : {0.0, 0.05, 0.15}) {
    const auto run = thrown(
        0.0, [=](Run<2>& r) { r.frictional(1, 0, coefficient); }, 1e8);
    CAPTURE(coefficient);
    // But for the start, whose push friction feels 1 ms late.
    CHECK(given_by_walls(*run, 0) ==
          Approx(-coefficient * given_by_walls(*run, 1)).epsilon(5e-3).margin(1e-9));
    // On the mean the wall carries the weight, but for the trembling.
    CHECK(momentum_of(*run, 0) / mass == Approx(1.0 - coefficient * 10 * 0.5).epsilon(0.05));
  }
}

TEST_CASE("a frictional wall stops a block that is slow") {
  const auto run = thrown(
      0.0, [](Run<2>& r) { r.frictional(1, 0, 0.8); }, 1e7);
  // 1 m/s would last 0.125 s. Nothing damps the shear vibration that is left, 0.019 s a period: the
  // block stays on the mean.
  const auto place = [&] {
    double sum = 0.0;
    for (Index row = 0; row < run->points.size(); ++row) {
      sum += run->points.position<2>(row)[0];
    }
    return sum / static_cast<double>(run->points.size());
  };
  double early = 0.0, late = 0.0;
  for (double* mean : {&early, &late}) {
    const double begin = run->time;
    while (run->time < begin + 0.19) {
      const double step = run->automatic_step();
      run->advance(step);
      *mean += step * place() / 0.19;
    }
  }
  CAPTURE((late - early) / 0.19);
  CHECK(std::abs(late - early) / 0.19 < 0.01);
  CHECK(run->value("wall friction") > 0.3 * 0.5 * mass);
}

TEST_CASE("a frictional wall lets a block part, a roller does not") {
  const auto free = thrown(4.0, [](Run<2>& r) { r.frictional(1, 0, 0.5); });
  CHECK(given_by_walls(*free, 0) == 0.0);
  CHECK(given_by_walls(*free, 1) == 0.0);
  CHECK(lowest(*free) == Approx(0.025 + 4 * 0.5 - 0.5 * 10 * 0.25).epsilon(1e-9));
  const auto held = thrown(4.0, [](Run<2>& r) { r.roller(1, 0); });
  CHECK(lowest(*held) < 0.1);
  CHECK(momentum_of(*held, 0) == Approx(mass).epsilon(1e-12));  // it slides
}

TEST_CASE("a wall without slip holds a block along and across") {
  const auto run = thrown(1.0, [](Run<2>& r) { r.no_slip(1, 0); });
  CHECK(lowest(*run) < 0.1);
  CHECK(std::abs(momentum_of(*run, 0)) < 0.5 * mass);
  double slid = 0.0;  // of the lowest row of points, whose cells the wall holds half
  for (Index row = 0; row < run->points.size(); ++row) {
    const Vec<2> x = run->points.position<2>(row);
    slid = x[1] < 0.05 ? std::max(slid, x[0] - 1.075) : slid;
  }
  CHECK(slid < 0.1);
}

TEST_CASE("points that separate beyond a cell fly on") {
  for (const ShapeFunction shape : all_shapes) {
    for (const StressUpdate update : all_updates) {
      for (const VelocityTransfer transfer : all_transfers) {
        if (is_refused(transfer, shape)) {
          continue;
        }
        CAPTURE(name_of(shape), name_of(update), name_of(transfer));
        Run<2> run(Grid<2>({0, 0}, {8, 8}, 0.1), shape);
        run.add({soil(1e5, 30),
                 0.25,
                 [](const Vec3& x) { return Vec3(20 * (x[0] - 4), 20 * (x[1] - 4), 0); },
                 {}},
                2, [](const Vec<2>& x) { return (x - Vec<2>(4, 4)).norm() < 0.2; });
        run.problem.settings.stress_update = update;
        run.problem.settings.transfer = transfer;
        run.start();
        const double energy = run.value("kinetic energy");
        run.until(0.5);
        // Eleven times as far apart as at the start: 5.5 cells from point to point.
        CHECK(run.value("kinetic energy") <= energy * (1 + 1e-9));
        CHECK(run.value("kinetic energy") > 0.5 * energy);
        CHECK(std::abs(run.solver->balances()[1].residual()) < 1e-12);
        double farthest = 0.0;
        for (Index row = 0; row < run.points.size(); ++row) {
          farthest = std::max(farthest, (run.points.position<2>(row) - Vec<2>(4, 4)).norm());
          REQUIRE(std::isfinite(run.solver->stress()[4 * row]));
        }
        CHECK(farthest > 1.0);
      }
    }
  }
}
