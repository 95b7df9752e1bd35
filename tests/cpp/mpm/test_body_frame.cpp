#include <catch2/catch.hpp>

#include "lapilli/geometry/prescribed_motion.hpp"
#include "lapilli/geometry/rigid_motion.hpp"
#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

using scenes::by_id;
using scenes::Trial;

Rotation turning(double speed = 0.3) {
  Rotation motion;
  motion.revolutions_per_second = speed;
  motion.center = {0.5, -0.25};
  return motion;
}

Translation sliding() { return {{0.7, -0.4}}; }

/// A scene whose one body moves, or rests.
Simulation start(const Trial<2>& trial, const std::optional<Motion>& motion, double step) {
  HeatProblem<2> problem = trial.problem();
  problem.moving = motion.has_value();
  problem.frame = motion;
  auto points = trial.points();
  std::vector<std::unique_ptr<Physics>> physics;
  physics.push_back(make_heat(*points, problem));
  if (motion) {
    physics.push_back(std::make_unique<PrescribedMotion<2>>(
        *points, std::vector<std::optional<Motion>>{motion}, true));
  }
  return Simulation(std::move(points), std::move(physics), {1e9, step});
}

bool has_field(Simulation& simulation, const std::string& name) {
  const auto fields = simulation.fields();
  return std::any_of(fields.begin(), fields.end(),
                     [&](const Field& field) { return field.name == name; });
}

TEST_CASE("A body that moves as a whole has the temperatures of one at rest") {
  for (const auto& motion : {Motion(turning()), Motion(sliding())}) {
    for (const bool implicit : {false, true}) {
      Trial<2> trial;
      trial.half = 3.0;
      trial.layout.angle = 20.0;
      trial.body.temperature = scenes::noise(0.0, 1.0);
      trial.body.source = 0.1;
      Convection law = scenes::convection(2.0, 0.0);
      law.ambient = Table{{0.0, 2.0}, {1.0, 3.0}};
      trial.settings.boundaries = {law};
      trial.settings.time_integration =
          implicit ? TimeIntegration::implicit_theta : TimeIntegration::explicit_euler;
      Simulation moved = start(trial, motion, implicit ? 0.5 : 0.05);
      Simulation rested = start(trial, std::nullopt, implicit ? 0.5 : 0.05);
      moved.run_until(2.0);
      rested.run_until(2.0);
      CHECK(by_id(moved, "temperature") == by_id(rested, "temperature"));
      CHECK(moved.balances().front().supplied() == rested.balances().front().supplied());
      const Placement now = placement_at(motion, 2.0, 2);
      const auto flux = by_id(moved, "heat_flux"), before = by_id(rested, "heat_flux");
      double worst = 0.0;
      for (std::size_t k = 0; k < flux.size(); k += 2) {
        const Vec<2> expected =
            now.turn.topLeftCorner<2, 2>() * Eigen::Map<const Vec<2>>(before.data() + k);
        worst = std::max(worst, (Eigen::Map<const Vec<2>>(flux.data() + k) - expected).norm());
      }
      CHECK(worst <= 1e-14);
      // Twice looked at is turned once.
      moved.fields();
      CHECK(by_id(moved, "heat_flux") == flux);
      for (Index row = 0; row < moved.points().size(); ++row) {
        Vec3 from = Vec3::Zero();
        from.head<2>() = rested.points().position<2>(row);
        CHECK((now(from).head<2>() - moved.points().position<2>(row)).norm() <= 1e-13);
      }
    }
  }
}

TEST_CASE("A body that turns meets conditions where they are in space") {
  const auto ambient = [](const Vec3& at, double time) { return 1.0 + at[0] + 0.1 * time; };
  const auto condition = [&](const std::optional<Motion>& frame) {
    return ArrayFunction([=](std::span<const Vec3> position, std::span<const double>, double time,
                             std::span<double> values) {
      const Placement now = frame ? placement_at(*frame, time, 2) : Placement{};
      for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = ambient(now(position[k]), time);
      }
    });
  };
  Trial<2> trial;
  trial.half = 3.0;
  trial.settings.boundaries = {scenes::convection(1.0, 0.0)};
  std::get<Convection>(trial.settings.boundaries[0]).ambient = condition(std::nullopt);
  trial.body.source = condition(std::nullopt);
  Simulation moved = start(trial, turning(), 0.05);
  std::get<Convection>(trial.settings.boundaries[0]).ambient = condition(turning());
  trial.body.source = condition(turning());
  Simulation rested = start(trial, std::nullopt, 0.05);
  moved.run_until(2.0);
  rested.run_until(2.0);
  CHECK(scenes::largest_difference(by_id(moved, "temperature"), by_id(rested, "temperature")) <=
        1e-12);
}

TEST_CASE("Regions that stay where they are ask for moving points, those that turn along do not") {
  Trial<2> trial;
  trial.half = 3.0;
  Convection law = scenes::convection(1.0, 1.0);
  law.region = Disk{{0.5, -0.25}, 3.4};
  trial.settings.boundaries = {law, scenes::convection(1.0, 0.0)};
  Simulation along = start(trial, turning(), 0.05);
  CHECK_FALSE(has_field(along, "temperature_carried"));
  law.region = HalfSpace{{0.0, 0.0}, {1.0, 0.0}};
  trial.settings.boundaries = {law, scenes::convection(1.0, 0.0)};
  Simulation across = start(trial, turning(), 0.05);
  CHECK(has_field(across, "temperature_carried"));
  trial.settings.transfer = HeatTransfer::nodal;
  CHECK_THROWS_WITH(start(trial, turning(), 0.05), Catch::Contains("one rigid motion"));
}

TEST_CASE("A motion knows which regions it maps onto themselves") {
  const Motion turn = turning(), slide = sliding();
  const Disk disk{{0.5, -0.25}, 2.0}, off{{0.0, 0.0}, 2.0};
  CHECK(carries_into_itself(turn, disk, 2));
  CHECK_FALSE(carries_into_itself(turn, off, 2));
  CHECK(carries_into_itself(turn, Annulus{{0.5, -0.25}, 1.0, 2.0}, 2));
  CHECK(carries_into_itself(turn, Difference{Shape(Disk{{0.5, -0.25}, 3.0}), Shape(disk)}, 2));
  CHECK_FALSE(carries_into_itself(turn, Union{{Shape(disk), Shape(off)}}, 2));
  CHECK_FALSE(carries_into_itself(turn, HalfSpace{{0.0, 0.0}, {1.0, 0.0}}, 2));
  CHECK(carries_into_itself(slide, HalfSpace{{0.0, 0.0}, {0.4, 0.7}}, 2));
  CHECK_FALSE(carries_into_itself(slide, HalfSpace{{0.0, 0.0}, {1.0, 0.0}}, 2));
  CHECK_FALSE(carries_into_itself(slide, disk, 2));
  Rotation tilted;
  tilted.revolutions_per_second = 1.0;
  tilted.axis = {1.0, 1.0, 0.0};
  CHECK(carries_into_itself(tilted, HalfSpace{{0.0, 0.0, 0.0}, {2.0, 2.0, 0.0}}, 3));
  CHECK(carries_into_itself(tilted, Sphere{{3.0, 3.0, 0.0}, 1.0}, 3));
  CHECK(carries_into_itself(tilted, Cylinder{{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, 1.0}, 3));
  CHECK_FALSE(carries_into_itself(tilted, Sphere{{3.0, 0.0, 0.0}, 1.0}, 3));
  CHECK(is_same(turn, Motion(turning())));
  CHECK_FALSE(is_same(turn, Motion(turning(0.4))));
  CHECK_FALSE(is_same(turn, slide));
}

TEST_CASE("A body that turns goes on from what was saved with the same bytes") {
  Trial<2> trial;
  trial.half = 3.0;
  trial.settings.boundaries = {scenes::convection(1.0, 1.0)};
  Simulation whole = start(trial, turning(), 0.05);
  whole.run_until(1.0);
  Archive archive;
  whole.save(archive);
  whole.run_until(2.0);
  Simulation again = start(trial, turning(), 0.05);
  again.load(archive);
  again.run_until(2.0);
  CHECK(by_id(whole, "temperature") == by_id(again, "temperature"));
  CHECK(by_id(whole, "heat_flux") == by_id(again, "heat_flux"));
}

}  // namespace
}  // namespace lapilli
