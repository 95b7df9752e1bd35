#include <catch2/catch.hpp>

#include "lapilli/core/parallel.hpp"
#include "lapilli/scene/build.hpp"
#include "lapilli/scene/check.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "scene/example_scenes.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const std::string cavity_scene = R"(
[grid]
lower = [-0.4, -0.4]
upper = [1.4, 1.4]
cell = 0.1
[[bodies]]
name = "air"
shape = {kind = "box", lower = [0, 0], upper = [1, 1]}
points_per_cell = 1
temperature = 0.5
[[bodies.material]]
kind = "thermal"
density = 1
specific_heat = 1
conductivity = 1
[[bodies.material]]
kind = "newtonian"
density = 1
viscosity = 0.71
thermal_expansion = 1
reference_temperature = 0.5
[peridynamics.heat]
[peridynamics.flow]
gravity = [0, -7100]
[[peridynamics.walls]]
name = "hot"
shape = {kind = "box", lower = [-0.4, -0.4], upper = [0, 1.4]}
heat = "temperature"
temperature = 1
[[peridynamics.walls]]
name = "cold"
shape = {kind = "box", lower = [1, -0.4], upper = [1.4, 1.4]}
heat = "temperature"
[[peridynamics.walls]]
name = "bottom"
shape = {kind = "box", lower = [-0.4, -0.4], upper = [1.4, 0]}
[[peridynamics.walls]]
name = "top"
shape = {kind = "box", lower = [-0.4, 1], upper = [1.4, 1.4]}
[time]
end = 0.02
)";

Scene scene_of(const std::string& text) { return parse_scene(text, "cavity.toml"); }

std::string refusal(const std::string& from, const std::string& to) {
  return error_of([&] { build(scene_of(replaced(cavity_scene, from, to))); });
}

}  // namespace

TEST_CASE("walls keep what the fluid can feel, and the first of two has the corner") {
  const auto simulation = build(scene_of(cavity_scene));
  std::vector<int> count(5, 0);
  for (const Index body : simulation->points().body()) {
    ++count[static_cast<std::size_t>(body)];
  }
  // Three layers of 10; of the 3 x 3 points in a corner, 8 lie within 3.015 spacings of it.
  CHECK(count == std::vector<int>{100, 30 + 16, 30 + 16, 30, 30});
  const CheckReport report = check(scene_of(cavity_scene));
  CHECK(report.bodies.at(1).name == "wall hot");
  CHECK_THAT(text_of(report), Contains("viscous flow, buoyancy"));
}

TEST_CASE("a place on the surface of the fluid belongs to the fluid, not to its wall as well") {
  std::string text = replaced(cavity_scene, "lower = [0, 0], upper = [1, 1]",
                              "lower = [0.05, 0.05], upper = [1, 1]");
  text = replaced(text, "upper = [0, 1.4]", "upper = [0.05, 1.4]");
  text = replaced(text, "lower = [-0.4, -0.4], upper = [1.4, 0]",
                  "lower = [-0.4, -0.4], upper = [1.4, 0.05]");
  const auto simulation = build(scene_of(text));
  const Points& points = simulation->points();
  CHECK(std::count(points.body().begin(), points.body().end(), 0) == 100);
  for (Index i = 0; i < points.size(); ++i) {
    for (Index j = 0; j < i; ++j) {
      REQUIRE((points.position<2>(i) - points.position<2>(j)).norm() > 0.09);
    }
  }
}

TEST_CASE("a scene of heat alone has no velocity and needs no fluid") {
  std::string text = replaced(cavity_scene, "[peridynamics.flow]\ngravity = [0, -7100]\n", "");
  text = replaced(text,
                  "[[bodies.material]]\nkind = \"newtonian\"\ndensity = 1\nviscosity = 0.71\n"
                  "thermal_expansion = 1\nreference_temperature = 0.5\n",
                  "");
  const auto simulation = build(scene_of(text));
  simulation->run_until(0.01);
  for (const Field& field : simulation->fields()) {
    CHECK(field.name != "velocity");
  }
  CHECK(std::abs(simulation->balances().at(0).residual()) < 1e-12);
}

TEST_CASE("mistakes in a peridynamic scene are named with place and number") {
  CHECK_THAT(refusal("[peridynamics.flow]", "[peridynamics.flow]\nhorizon = 0.8"),
             StartsWith("cavity.toml:") && Contains("must be above 1") && Contains("got 0.8"));
  CHECK_THAT(refusal("cell = 0.1", "cell = 0.2"),
             Contains("'hot' is about") && Contains("thinner than the horizon of 0.603"));
  CHECK_THAT(refusal("upper = [0, 1.4]", "upper = [0.2, 1.4]"),
             Contains("wall 'hot' overlaps the fluid body") && Contains("(0.05, 0.05, 0)"));
  CHECK_THAT(refusal("kind = \"newtonian\"", "kind = \"thermal\"\nspecific_heat = 1"),
             StartsWith("cavity.toml:"));
  CHECK_THAT(refusal("viscosity = 0.71", "viscosity = -1"), Contains("got -1"));
  CHECK_THAT(refusal("[peridynamics.heat]", "[heat]\n[peridynamics.heat]"),
             Contains("[peridynamics.heat] instead"));
  CHECK_THAT(refusal("gravity = [0, -7100]", "gravity = [0, 0, -7100]"),
             Contains("peridynamics.flow.gravity has 3 numbers"));
  CHECK_THAT(refusal("thermal_expansion = 1\n", ""),
             Contains("peridynamics.flow.gravity does nothing") && Contains("a thermal_expansion"));
  CHECK_THAT(refusal("temperature = 0.5\n",
                     "temperature = 0.5\nmotion = {kind = \"rotation\", "
                     "revolutions_per_second = 1}\n"),
             Contains("moves by its flow"));
  CHECK_THAT(
      refusal("lower = [-0.4, 1], upper = [1.4, 1.4]", "lower = [1.35, 1.35], upper = [1.4, 1.4]"),
      Contains("no point within the horizon") || Contains("contains no"));
}

TEST_CASE("mistakes in walls are named with the line of the wall") {
  // Line 37 is the top wall's table.
  CHECK_THAT(refusal("name = \"top\"", "name = \"top\"\nflux = 3"),
             StartsWith("cavity.toml:37:") && Contains("wall 'top' has a flux") &&
                 Contains("give heat = \"flux\""));
  CHECK_THAT(refusal("name = \"top\"", "name = \"top\"\nvelocity = [1, 0, 0]"),
             StartsWith("cavity.toml:37:") && Contains("3 numbers"));
  CHECK_THAT(refusal("name = \"top\"", "name = \"bottom\""),
             StartsWith("cavity.toml:38:") && Contains("is 'bottom' as that of another wall"));
  CHECK_THAT(refusal("upper = [0, 1.4]", "upper = [1.4, 1.4]"),
             StartsWith("cavity.toml:25:") && Contains("overlaps the fluid body"));
  CHECK_THAT(refusal("shape = {kind = \"box\", lower = [-0.4, 1], upper = [1.4, 1.4]}",
                     "shape = {kind = \"box\", lower = [-0.4, 1], upper = [0, 1.4]}"),
             StartsWith("cavity.toml:37:") && Contains("no point of its own"));
  CHECK_THAT(refusal("lower = [-0.4, 1], upper = [1.4, 1.4]", "lower = [0, 1.2], upper = [1, 1.4]"),
             Contains("no wall holds the fluid at (0.15, 0.95)"));
  CHECK_THAT(refusal("[peridynamics.heat]\n[peridynamics.flow]\ngravity = [0, -7100]\n", ""),
             Contains("models nothing"));
}

TEST_CASE("a peridynamic scene gives the same bytes for any threads and after a resume") {
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 4}) {
    set_thread_count(threads);
    auto run = build(scene_of(cavity_scene));
    run->run_until(0.01);
    Archive archive;
    run->save(archive);
    auto resumed = build(scene_of(cavity_scene));
    resumed->load(archive);
    for (const auto& one : {run.get(), resumed.get()}) {
      one->run_until(0.02);
      const auto position = one->points().position();
      results.emplace_back(position.begin(), position.end());
    }
  }
  set_thread_count(0);
  for (const auto& result : results) {
    CHECK(result == results[0]);
  }
}
