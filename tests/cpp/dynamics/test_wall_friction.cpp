// Coulomb friction on faces of the grid: elastic blocks that slide and stick, whatever the cells.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "dynamics/same_bytes.hpp"

using namespace dynamics_test;

namespace {

constexpr double g = 9.81;

/// A block of .8 by .4 m on the lower face of a tilted grid, which bears its weight from the start.
std::unique_ptr<Run<2>> tilted(double cell, double stiffness, double friction, double degrees) {
  const double tilt = degrees * std::numbers::pi / 180;
  auto run = std::make_unique<Run<2>>(Grid<2>({0, 0}, {1.6, 0.6}, cell), ShapeFunction::gimp);
  run->add({elastic(2000, stiffness, 0.3),
            0.25,
            {},
            [=](const Vec3& x) {
              const double weight = 2000.0 * g * std::max(0.0, 0.4 - x[1]);
              const double across = -weight * std::cos(tilt);
              return SymmetricTensor(0.43 * across, across, 0.43 * across, weight * std::sin(tilt),
                                     0, 0);
            }},
           2, [](const Vec<2>& x) { return x[0] > 0.2 && x[0] < 1.0 && x[1] < 0.4; });
  run->problem.settings.gravity = {g * std::sin(tilt), -g * std::cos(tilt)};
  run->frictional(1, 0, friction);
  return run;
}

double mean_place(const Run<2>& run) {
  double sum = 0.0;
  for (Index row = 0; row < run.points.size(); ++row) {
    sum += run.points.position<2>(row)[0];
  }
  return sum / static_cast<double>(run.points.size());
}

/// Stored momentum and impulse of the walls, along and across the face, N s.
struct Motion {
  explicit Motion(const Run<2>& run)
      : stored(run.solver->balances()[1].stored),
        drag(run.solver->balances()[1].entries[1].in),
        push(run.solver->balances()[2].entries[1].in) {}
  double stored, drag, push;
};

}  // namespace

TEST_CASE("a block slides on a face by Coulomb's law, whatever its cells and stiffness") {
  constexpr double mass = 2000 * 0.8 * 0.4, span = 0.15;
  for (const auto& [friction, degrees] : {std::pair{0.6, 40.0}, {0.3, 30.0}}) {
    for (const double cell : {0.1, 0.05, 0.025}) {
      for (const double stiffness : {5e6, 2e7}) {
        const auto run = tilted(cell, stiffness, friction, degrees);
        run->start();
        run->until(0.05);
        const Motion before(*run);
        run->until(0.05 + span);
        const Motion after(*run);
        const double tilt = degrees * std::numbers::pi / 180;
        const double exact = std::sin(tilt) - friction * std::cos(tilt);
        const double found = (after.stored - before.stored) / (mass * span * g);
        const double ratio = (before.drag - after.drag) / (after.push - before.push);
        CAPTURE(friction, degrees, cell, stiffness, found, exact, ratio);
        CHECK(std::abs(ratio - friction) < 0.02);
        CHECK(std::abs(found - exact) < 0.02);
      }
    }
  }
}

TEST_CASE("a face holds a block that its friction can hold, whatever its cells") {
  for (const double cell : {0.1, 0.05, 0.025}) {
    const auto run = tilted(cell, 5e6, 0.5, 25.0);
    run->start();
    const double start = mean_place(*run);
    run->until(0.1);
    const double early = mean_place(*run);
    run->until(0.2);
    // Found .4 to 1.2 mm, of its edges; at .04 g it slides by 6.
    CAPTURE(cell, early - start, mean_place(*run) - early);
    CHECK(std::abs(mean_place(*run) - early) < 0.002);
  }
}

TEST_CASE("friction on a face gives the same bytes for any threads and on resume") {
  check_same_bytes([] { return tilted(0.1, 5e6, 0.6, 40.0); }, 40, 13,
                   [](const Run<2>& run) { CHECK(run.value("wall friction") > 0.0); });
  const auto two_bodies = [] {
    auto run = tilted(0.1, 5e6, 0.6, 40.0);
    run->add({elastic(2000, 5e6, 0.3), 0.25, [](const Vec3&) { return Vec3(-3, 0, 0); }, {}}, 2,
             [](const Vec<2>& x) { return x[0] > 1.15 && x[1] < 0.2; });
    return run;
  };
  check_same_bytes(two_bodies, 40, 21, [](const Run<2>&) {});
}

TEST_CASE("a state without the felt forces of faces goes on from those of the next step") {
  auto run = tilted(0.1, 5e6, 0.6, 40.0);
  run->start();
  for (int k = 0; k < 20; ++k) {
    run->advance(run->automatic_step());
  }
  const Archive whole = snapshot(*run);
  Archive old;
  for (const auto& [name, array] : whole.arrays()) {
    if (!name.starts_with("dynamics/walls/")) {
      old.insert(name, array);
    }
  }
  REQUIRE(old.arrays().size() + 2 == whole.arrays().size());
  auto resumed = tilted(0.1, 5e6, 0.6, 40.0);
  resumed->start();
  resumed->points.load(old);
  resumed->solver->load(old);
  resumed->advance(resumed->automatic_step());
  CHECK(resumed->value("kinetic energy") == Approx(run->value("kinetic energy")).epsilon(0.1));
}
