// Threads, resume, bad input and failing runs.
#include <catch2/catch.hpp>
#include <cstring>
#include <limits>

#include "dynamics/same_bytes.hpp"
#include "lapilli/core/require.hpp"

using namespace dynamics_test;

namespace {

/// Soil that falls on the floor and spreads, thrown to one side so that points change strips.
template <int Dim>
std::unique_ptr<Run<Dim>> heap(ShapeFunction shape, StressUpdate update, VelocityTransfer transfer,
                               std::optional<bool> b_bar = {}) {
  Vec<Dim> upper = Vec<Dim>::Constant(Dim == 2 ? 3.0 : 1.6);
  auto run = std::make_unique<Run<Dim>>(Grid<Dim>(Vec<Dim>::Zero(), upper, 0.1), shape);
  const double size = Dim == 2 ? 1.5 : 0.7;
  run->add({soil(1e5, 30), 0.25, [](const Vec3&) { return Vec3(1.5, -1.0, -1.0); }, {}}, 2,
           [=](const Vec<Dim>& x) { return x.maxCoeff() < size; });
  run->problem.settings.gravity.assign(Dim, 0.0);
  run->problem.settings.gravity.back() = -9.81;
  run->problem.settings.stress_update = update;
  run->problem.settings.transfer = transfer;
  run->problem.settings.b_bar = b_bar;
  for (int axis = 0; axis < Dim; ++axis) {
    if (axis == Dim - 1) {
      run->frictional(axis, 0, 0.4);
    } else {
      run->roller(axis, 0);
    }
    run->roller(axis, 1);
  }
  return run;
}

bool same_bytes(const Archive& a, const Archive& b) {
  for (const auto& [name, array] : a.arrays()) {
    if (const auto* numbers = std::get_if<std::vector<double>>(&array)) {
      const auto& others = std::get<std::vector<double>>(b.arrays().at(name));
      if (numbers->size() != others.size() ||
          std::memcmp(numbers->data(), others.data(), numbers->size() * sizeof(double)) != 0) {
        UNSCOPED_INFO("differs: " << name);
        return false;
      }
    } else if (array != b.arrays().at(name)) {
      UNSCOPED_INFO("differs: " << name);
      return false;
    }
  }
  return true;
}

template <int Dim>
void check_threads(ShapeFunction shape, StressUpdate update, VelocityTransfer transfer, int steps,
                   std::optional<bool> b_bar = {}) {
  Archive alone;
  for (int threads : {1, 2, 4}) {
    auto run = heap<Dim>(shape, update, transfer, b_bar);
    run->start(threads);
    for (int k = 0; k < steps; ++k) {
      run->advance(run->automatic_step());
    }
    if (threads == 1) {
      alone = snapshot(*run);
      REQUIRE(run->points.ordering() > 1);  // points were sorted again on the way
    } else {
      CAPTURE(Dim, name_of(shape), name_of(update), name_of(transfer), threads);
      REQUIRE(same_bytes(alone, snapshot(*run)));
    }
  }
  set_thread_count(0);
}

}  // namespace

TEST_CASE("momentum gives the same bytes for 1, 2 and 4 threads") {
  check_threads<2>(ShapeFunction::linear, StressUpdate::usl, VelocityTransfer::flip, 120);
  check_threads<2>(ShapeFunction::gimp, StressUpdate::musl, VelocityTransfer::tpic, 120);
  check_threads<2>(ShapeFunction::gimp, StressUpdate::musl, VelocityTransfer::blended_apic, 120);
  check_threads<3>(ShapeFunction::linear, StressUpdate::musl, VelocityTransfer::flip, 50);
  check_threads<3>(ShapeFunction::bspline, StressUpdate::usl, VelocityTransfer::apic, 50);
  check_threads<3>(ShapeFunction::gimp, StressUpdate::usl, VelocityTransfer::blended_apic, 50);
  for (const ShapeFunction shape : all_shapes) {
    check_threads<2>(shape, StressUpdate::musl, VelocityTransfer::blended_apic, 120, true);
  }
  check_threads<3>(ShapeFunction::gimp, StressUpdate::musl, VelocityTransfer::blended_apic, 50,
                   true);
}

TEST_CASE("a run that is resumed in mid-collapse gives the same bytes") {
  for (VelocityTransfer transfer : all_transfers) {
    const auto at = [&](int steps, Archive* from, Archive* to) {
      const bool b_bar = transfer == VelocityTransfer::blended_apic;
      auto run = heap<2>(ShapeFunction::gimp, StressUpdate::musl, transfer, b_bar);
      run->start();
      if (from) {
        run->points.load(*from);
        run->solver->load(*from);
      }
      for (int k = 0; k < steps; ++k) {
        run->advance(run->automatic_step());
      }
      *to = snapshot(*run);
    };
    Archive whole, middle, resumed;
    at(90, nullptr, &whole);
    at(53, nullptr, &middle);
    at(37, &middle, &resumed);
    CAPTURE(name_of(transfer));
    REQUIRE(same_bytes(whole, resumed));
  }
}

TEST_CASE("a point that leaves the grid stops the run with its id and the grid") {
  Run<2> run(Grid<2>({0, 0}, {1, 1}, 0.1), ShapeFunction::linear);
  run.add({elastic(1000, 1e5, 0.3), 0.25, [](const Vec3&) { return Vec3(5, 0, 0); }, {}}, 2,
          [](const Vec<2>& x) { return x[0] > 0.5; });
  run.start();
  REQUIRE_THROWS_WITH(run.until(1.0),
                      Catch::Contains("point ") && Catch::Contains("left the grid"));
}

TEST_CASE("a value that is not finite stops the run and names the point") {
  Run<2> run(Grid<2>({0, 0}, {1, 1}, 0.1), ShapeFunction::gimp);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  run.add({elastic(1000, 1e5, 0.3),
           0.25,
           {},
           [=](const Vec3& x) { return SymmetricTensor(x[0] < 0.45 ? nan : 0.0); }},
          2, [](const Vec<2>& x) { return x[0] > 0.4 && x[0] < 0.6 && x[1] > 0.4 && x[1] < 0.6; });
  run.start();
  REQUIRE_THROWS_WITH(run.advance(1e-4), Catch::Contains("not finite"));
}

TEST_CASE("a step above the limit is refused with the limit and its reason") {
  auto run = heap<2>(ShapeFunction::linear, StressUpdate::usl, VelocityTransfer::flip);
  run->start();
  const StepLimit limit = run->solver->step_limit();
  REQUIRE(limit.automatic == Approx(0.5 * limit.hard));
  const double wave = std::sqrt(soil(1e5, 30).elastic.wave_modulus() / 2000.0);
  REQUIRE(limit.hard == Approx(0.1 / (wave + std::sqrt(1.5 * 1.5 + 1.0))).epsilon(1e-12));
  auto points = std::make_unique<Points>(2);
  fill<2>(*points, run->problem.grid, 2, [](const Vec<2>& x) { return x[0] < 0.5; });
  std::vector<std::unique_ptr<Physics>> physics;
  physics.push_back(make_dynamics<2>(*points, run->problem));
  REQUIRE_THROWS_WITH(Simulation(std::move(points), std::move(physics), {1.0, 2.0 * limit.hard}),
                      Catch::Contains("above the limit") && Catch::Contains("wave"));
}

TEST_CASE("settings out of range are refused") {
  const auto refused = [](auto change, const char* says) {
    auto run = heap<2>(ShapeFunction::linear, StressUpdate::usl, VelocityTransfer::flip);
    change(*run);
    REQUIRE_THROWS_WITH(run->start(), Catch::Contains(says));
  };
  refused([](Run<2>& run) { run.problem.settings.pic_fraction = 1.1; }, "pic_fraction");
  refused([](Run<2>& run) { run.problem.settings.blend_rate = -1.0; }, "blend_rate");
  refused([](Run<2>& run) { run.problem.settings.courant = 0.0; }, "courant");
  refused([](Run<2>& run) { run.problem.settings.gravity[0] = NAN; }, "gravity");
  refused([](Run<2>& run) { run.problem.settings.gravity = {1.0}; }, "gravity");
  refused([](Run<2>& run) { run.frictional(0, 0, 0.3); }, "two walls");
  refused([](Run<2>& run) { run.roller(2, 0); }, "z_lower");
  refused(
      [](Run<2>& run) {
        run.problem.settings.grid_boundaries = {FrictionalBoundary{GridFace::x_lower, -1}};
      },
      "coefficient");
  refused([](Run<2>& run) { run.problem.settings.transfer = VelocityTransfer::apic; },
          "gimp or bspline");
  refused([](Run<2>& run) { run.problem.settings.transfer = VelocityTransfer::tpic; },
          "gimp or bspline");
  refused(
      [](Run<2>& run) {
        for (Index row = 0; row < run.points.size(); ++row) {
          run.points.position()[2 * row] += 0.01 * std::sin(7.0 * static_cast<double>(row));
          run.points.position()[2 * row + 1] += 0.01 * std::cos(9.0 * static_cast<double>(row));
        }
      },
      "lattice");
  refused([](Run<2>& run) { run.problem.bodies.clear(); }, "bod");
  refused([](Run<2>& run) { run.problem.bodies[0].half_width = 0.6; }, "half width");
  refused([](Run<2>& run) { run.problem.bodies[0].material = elastic(0.0, 1e5, 0.3); }, "density");
  refused(
      [](Run<2>& run) {
        MohrCoulomb material = soil(1e5, 30);
        material.dilatancy_angle = 40;
        run.problem.bodies[0].material = material;
      },
      "dilatancy_angle");
}

TEST_CASE("extreme scenes stay finite or stop with a cause") {
  // One to 36 points per cell, soft to stiff, slippery to rough; each until it has fallen and met
  // the floor, at most 3000 steps.
  int finished = 0;
  for (double young : {1e3, 1e6, 1e11}) {
    for (double friction : {0.0, 30.0, 60.0}) {
      for (int per_axis : {1, 2, 6}) {
        for (StressUpdate update : all_updates) {
          Run<2> run(Grid<2>({0, 0}, {3, 1.5}, 0.25), ShapeFunction::linear);
          run.add({soil(young, friction), 0.25, [](const Vec3&) { return Vec3(0.5, -1, 0); }, {}},
                  per_axis, [](const Vec<2>& x) { return x[0] > 1 && x[0] < 2 && x[1] < 1; });
          run.problem.settings.gravity = {0, -9.81};
          run.problem.settings.stress_update = update;
          run.frictional(1, 0, 0.5);
          run.roller(0, 0);
          run.roller(0, 1);
          run.roller(1, 1);
          CAPTURE(young, friction, per_axis, name_of(update));
          run.start();
          try {
            for (int k = 0; k < 300 && run.time < 1.0; ++k) {
              run.advance(run.automatic_step());
            }
            ++finished;
          } catch (const RunError& error) {
            REQUIRE_THAT(error.what(), Catch::Contains("point"));
          }
          for (Field& field : run.solver->fields()) {
            run.solver->refresh_output();
            CAPTURE(field.name);
            REQUIRE(std::all_of(field.values.begin(), field.values.end(),
                                [](double value) { return std::isfinite(value); }));
          }
        }
      }
    }
  }
  CAPTURE(finished);
  REQUIRE(finished >= 50);
}

TEST_CASE("two bodies that collide at 100 m/s stay finite or stop with a cause") {
  for (ShapeFunction shape : all_shapes) {
    for (StressUpdate update : all_updates) {
      Run<2> run(Grid<2>({0, 0}, {4, 2}, 0.1), shape);
      for (double side : {-1.0, 1.0}) {
        run.add({elastic(1000, 1e7, 0.3),
                 0.25,
                 [=](const Vec3&) { return Vec3(-50 * side, 0, 0); },
                 {}},
                2, [=](const Vec<2>& x) { return (x - Vec<2>(2 + 0.45 * side, 1)).norm() < 0.4; });
      }
      run.problem.settings.stress_update = update;
      run.start();
      CAPTURE(name_of(shape), name_of(update));
      try {
        run.until(0.02);
        REQUIRE(std::isfinite(run.value("kinetic energy")));
      } catch (const RunError& error) {
        WARN(name_of(shape) << " " << name_of(update) << ": " << error.what());
        REQUIRE_THAT(error.what(), Catch::Contains("point"));
      }
    }
  }
}

TEST_CASE("momentum shows its fields and allocates nothing that was not asked for") {
  auto run = heap<2>(ShapeFunction::linear, StressUpdate::usl, VelocityTransfer::flip);
  run->start();
  std::vector<std::string> names;
  for (const Field& field : run->solver->fields()) {
    names.push_back(field.name);
    REQUIRE(static_cast<Index>(field.values.size()) == run->points.size() * field.components);
  }
  REQUIRE(names == std::vector<std::string>{"velocity", "stress", "density"});
  const Archive archive = snapshot(*run);
  for (const char* absent : {"affine", "deformation", "plastic", "free_strain"}) {
    REQUIRE_FALSE(archive.contains(message("dynamics/", absent)));
  }
}

TEST_CASE("plastic work that a point keeps adds up to the account") {
  auto run = heap<2>(ShapeFunction::gimp, StressUpdate::musl, VelocityTransfer::flip);
  run->start();
  const PointArray& work = run->solver->plastic_work();
  const PointArray& deformation = run->solver->incremental_deformation();
  for (int k = 0; k < 60; ++k) {
    run->advance(run->automatic_step());
  }
  double sum = 0.0, largest = 0.0;
  for (Index row = 0; row < run->points.size(); ++row) {
    sum += work[row];
    largest = std::max(largest, std::abs(deformation[4 * row]));
  }
  REQUIRE(run->value("plastic dissipation") > 0.0);
  REQUIRE(sum == Approx(run->value("plastic dissipation")).epsilon(1e-12));
  REQUIRE(largest > 0.0);
}
