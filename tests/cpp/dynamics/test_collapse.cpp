#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "dynamics/fixtures.hpp"

using namespace dynamics_test;

namespace {

/// A column of dry soil, half of it, against a roller on its axis and a no-slip floor, let go.
std::unique_ptr<Run<2>> column(double aspect, double h, int per_axis, StressUpdate update,
                               double friction = 30.0) {
  const double radius = 1.0, reach = radius * (1.0 + 4.0 * std::max(aspect, 1.0));
  const double width = std::ceil(reach / h) * h,
               height = std::ceil((aspect * radius + 0.5) / h) * h;
  auto run = std::make_unique<Run<2>>(Grid<2>({0, 0}, {width, height}, h), ShapeFunction::gimp);
  DynamicsBody body{soil(1e6, friction), 0.25, {}, {}};
  run->add(body, per_axis,
           [=](const Vec<2>& x) { return x[0] < radius && x[1] < aspect * radius; });
  run->problem.settings.gravity = {0, -9.81};
  run->problem.settings.stress_update = update;
  run->roller(0, 0);
  run->no_slip(1, 0);
  run->start();
  return run;
}

/// As far as 99.5 % of the sand has come: the laws leave out grains that roll ahead. A depth in
/// cells would follow the thin edge outwards as they shrink.
double front(const Run<2>& run) {
  std::vector<double> x;
  for (Index row = 0; row < run.points.size(); ++row) {
    x.push_back(run.points.position<2>(row)[0]);
  }
  std::ranges::sort(x);
  return x[static_cast<std::size_t>(0.995 * static_cast<double>(x.size()))];
}

/// Until the motion has died down: some times the time of fall.
void collapse(Run<2>& run, double aspect) { run.until(3.0 * std::sqrt(2.0 * aspect / 9.81) + 1.5); }

}  // namespace

TEST_CASE("a collapsing column closes its energy account") {
  for (StressUpdate update : all_updates) {
    auto run = column(1.0, 0.1, 3, update);
    const double before = run->value("potential energy");
    collapse(*run, 1.0);
    const double released = before - run->value("potential energy");
    const Balance energy = run->solver->balances()[0];
    const double gap = energy.stored - energy.initial - energy.supplied();
    CAPTURE(name_of(update), released, gap / released, run->value("plastic dissipation") / released,
            run->value("transfer loss") / released, run->value("wall impact") / released,
            run->value("wall friction") / released);
    CHECK(std::abs(gap) < 0.001 * released);  // found 4e-5; with the stress reached .01 to .02
    CHECK(run->value("plastic dissipation") > 0.3 * released);
    CHECK(run->value("kinetic energy") < 0.01 * released);
  }
}

TEST_CASE("run-out of a short column lies between the published laws") {
  // (d_inf - d_i) / d_i = 1.2 a (Lube et al. 2005) to 1.35 times that: the laws for the plane reach
  // 1.8 a (Lajeunesse et al. 2005), and nothing but friction damps here. 1.57; 1.65 at half the
  // cell, 1.69 at a quarter, since at constant volume this soil reposes at 26.6 degrees.
  auto run = column(1.0, 0.1, 3, StressUpdate::musl);
  collapse(*run, 1.0);
  const double run_out = front(*run) - 1.0;
  CAPTURE(run_out);
  CHECK(run_out > 0.99 * 1.2);
  CHECK(run_out < 1.35 * 1.2);
  double volume = 0.0;
  for (Index row = 0; row < run->points.size(); ++row) {
    volume += run->points.volume()[row];
  }
  CHECK(volume < 1.13);  // of 1: what flies apart closes again where it lands; 1.16 did not
}

TEST_CASE("run-out over aspect ratio and cell size", "[.slow]") {
  // Grains that repose at 30 degrees, as those of the laws, have sin(phi) = tan(30) where they
  // yield at constant volume (Davis 1968).
  const double friction = std::asin(std::tan(std::numbers::pi / 6)) * 180 / std::numbers::pi;
  for (double aspect : {0.5, 1.0, 1.5, 2.0, 4.0, 8.0}) {
    double coarser = 0.0;
    for (double h : {0.1, 0.05, 0.025}) {
      if (aspect > 2.0 && h < 0.05) {
        continue;
      }
      auto run = column(aspect, h, 3, StressUpdate::musl, friction);
      const double before = run->value("potential energy");
      collapse(*run, aspect);
      const double run_out = front(*run) - 1.0;
      const Balance energy = run->solver->balances()[0];
      const double gap = (energy.stored - energy.initial - energy.supplied()) /
                         (before - run->value("potential energy"));
      WARN("a " << aspect << " h " << h << " run-out " << run_out << " over a: " << run_out / aspect
                << " over 1.9 a^(2/3): " << run_out / (1.9 * std::pow(aspect, 2.0 / 3.0))
                << " energy gap " << gap << " steps " << run->index);
      CHECK(std::abs(gap) < 0.01);
      if (aspect <= 1.5 && std::min(aspect, 1.0) > 10.5 * h) {  // ten cells are too few
        CHECK(run_out > 1.2 * aspect);
        CHECK(run_out < 1.35 * 1.2 * aspect);
        CHECK((h > 0.03 || run_out < 1.1 * coarser));
      }
      coarser = run_out;
    }
  }
}

namespace {

/// A layer of soil on a rough plane inclined by `slope`, in axes along and across it, started from
/// the stress of an infinite slope. Returns the largest displacement over the cell size.
double creep(double slope, double h, double time) {
  const double depth = 0.5, angle = slope * std::numbers::pi / 180, g = 9.81, density = 2000;
  Run<2> run(Grid<2>({0, 0}, {4.0, 1.0}, h), ShapeFunction::gimp);
  // Held at both ends by its own weight's stress on no-slip walls.
  const double k0 = 0.6;
  DynamicsBody body{soil(1e6, 30), 0.25, {}, [=](const Vec3& x) {
                      const double across = -density * g * std::cos(angle) * (depth - x[1]);
                      const double shear = -density * g * std::sin(angle) * (depth - x[1]);
                      return SymmetricTensor(k0 * across, across, k0 * across, -shear, 0, 0);
                    }};
  run.add(body, 3, [=](const Vec<2>& x) { return x[1] < depth; });
  run.problem.settings.gravity = {g * std::sin(angle), -g * std::cos(angle)};
  run.no_slip(0, 0);
  run.no_slip(0, 1);
  run.no_slip(1, 0);
  run.start();
  std::vector<Vec<2>> start(static_cast<std::size_t>(run.points.size()));
  for (Index row = 0; row < run.points.size(); ++row) {
    start[run.points.id()[row]] = run.points.position<2>(row);
  }
  run.until(time);
  double furthest = 0.0;
  for (Index row = 0; row < run.points.size(); ++row) {
    furthest =
        std::max(furthest, (run.points.position<2>(row) - start[run.points.id()[row]]).norm());
  }
  return furthest / h;
}

}  // namespace

TEST_CASE("a slope below the friction angle stays") {
  const double moved = creep(20.0, 0.1, 2.0);
  CAPTURE(moved);
  CHECK(moved < 0.1);
}

TEST_CASE("a slope below the friction angle stays for ten seconds", "[.slow]") {
  for (double h : {0.1, 0.05}) {
    const double moved = creep(20.0, h, 10.0);
    WARN("h " << h << ": moved " << moved << " cells");
    CHECK(moved < 0.1);
  }
}
