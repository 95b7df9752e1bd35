#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "lapilli/core/require.hpp"
#include "lapilli/scene/scene_file.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;

namespace {

const std::string ring = R"(
title = "ring"
[grid]
lower = [-5.5, -5.5]
upper = [5.5, 5.5]
cell = 0.1
[[bodies]]
shape = {kind = "annulus", inner = 1, outer = 5}
material = {kind = "thermal", density = 1, specific_heat = 1, conductivity = 1}
[heat]
transfer = "nodal"
[[heat.boundaries]]
kind = "convection"
coefficient = 1
ambient = {times = [0, 1], values = [1, 2]}
[time]
end = 10
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string error_of(const std::string& text) {
  try {
    parse_scene(text, "ring.toml");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a scene is read into its structs") {
  const Scene scene = parse_scene(ring, "ring.toml");
  CHECK(scene.title == "ring");
  CHECK(scene.grid.cell == 0.1);
  REQUIRE(scene.bodies.size() == 1);
  const auto& annulus = std::get<Annulus>(*scene.bodies[0].shape);
  CHECK(annulus.outer == 5.0);
  CHECK(std::get<Thermal>(scene.bodies[0].material.at(0)).conductivity == SymmetricTensor(1.0));
  REQUIRE(scene.heat);
  CHECK(scene.heat->transfer == HeatTransfer::nodal);
  const auto& convection = std::get<Convection>(scene.heat->boundaries.at(0));
  CHECK(convection.ambient.at(0.5) == 1.5);
  CHECK_FALSE(scene.time.step);
}

TEST_CASE("what is written reads back to the same text") {
  for (const Members members : {Members::changed, Members::all}) {
    const std::string text = to_toml(parse_scene(ring, "ring.toml"), members);
    CAPTURE(text);
    CHECK(to_toml(parse_scene(text, "again.toml"), members) == text);
  }
  CHECK_THAT(to_toml(parse_scene(ring, "ring.toml"), Members::all), Contains("step = \"auto\""));
  CHECK_THAT(to_json(parse_scene(ring, "ring.toml")), Contains("\"cell\": 0.1,"));
}

TEST_CASE("a mistake names file, line, column, key, and what is allowed") {
  struct Mistake {
    const char *from, *to, *message;
  };
  const auto mistake = GENERATE(
      Mistake{
          "cell = 0.1", "cel = 0.1",
          "ring.toml:6:1: grid.cel is no known key; did you mean 'cell'? allowed: lower, upper, "
          "cell, shape_function"},
      Mistake{"cell = 0.1", "wavelength = 0.1", "grid.wavelength is no known key; allowed: lower"},
      Mistake{"cell = 0.1", "cell = \"fine\"",
              "ring.toml:6:8: grid.cell must be a number in m, got the text \"fine\""},
      Mistake{"cell = 0.1", "cell = -1", "ring.toml:6:8: grid.cell must be above 0 (m), got -1"},
      Mistake{"cell = 0.1", "cell = nan", "grid.cell must be above 0 (m), got nan"},
      Mistake{"cell = 0.1", "cell = 1979-05-27", "grid.cell must be a number in m, got a date"},
      Mistake{"cell = 0.1", "", "ring.toml:3:1: grid.cell is missing: size of a cell in m"},
      Mistake{"[-5.5, -5.5]", "[]", "ring.toml:4:9: grid.lower must hold 1 to 3 entries, got 0"},
      Mistake{"[-5.5, -5.5]", "[1, true]", "grid.lower[1] must be a number in m, got true"},
      Mistake{"[-5.5, -5.5]", "1", "grid.lower must be a list, got 1"},
      Mistake{
          "\"nodal\"", "\"nodl\"",
          "ring.toml:11:12: heat.transfer knows no 'nodl'; did you mean 'nodal'? allowed: auto, "},
      Mistake{"\"nodal\"", "1", "heat.transfer must be one of auto, nodal"},
      Mistake{"\"annulus\"", "\"anulus\"",
              "bodies[0].shape.kind knows no 'anulus'; did you mean 'annulus'"},
      Mistake{"kind = \"annulus\", ", "", "bodies[0].shape.kind is missing: which of box"},
      Mistake{"outer = 5", "outer = [5]",
              "bodies[0].shape.outer must be a number in m, got a list of 1"},
      Mistake{"[0, 1]", "[1, 0]", "heat.boundaries[0].ambient.times must increase"},
      Mistake{"[0, 1]", "[0]", "needs as many values as times, got 2 and 1"},
      Mistake{"[heat]", "[hat]", "ring.toml:10:2: hat is no known key; did you mean 'heat'"},
      Mistake{"end = 10", "end = 10\nstep = \"fast\"",
              "time.step must be a number in s or \"auto\", got the text \"fast\""},
      Mistake{"end = 10", "end = 10\nsteps = 2.5", "time.steps must be an integer, got 2.5"},
      Mistake{"cell = 0.1", "cell = ", "ring.toml:6:8: no valid TOML: "});
  const std::string message = error_of(replaced(ring, mistake.from, mistake.to));
  CHECK_THAT(message, Contains(mistake.message));
  CHECK_THAT(message, Catch::Matchers::StartsWith("ring.toml:"));
}

TEST_CASE("all mistakes of a file are told at once, each with its line") {
  std::string text = replaced(ring, "cell = 0.1", "cel = 0.1");
  text = replaced(text, "outer = 5", "outer = -5");
  text = replaced(text, "\"nodal\"", "\"nodl\"");
  text = replaced(text, "end = 10", "end = \"soon\"");
  const std::string all = error_of(text);
  CAPTURE(all);
  CHECK(std::count(all.begin(), all.end(), '\n') == 3);
  for (const char* one : {"ring.toml:6:1: grid.cel is no known key",
                          "ring.toml:8:", "ring.toml:11:12: heat.transfer knows no 'nodl'",
                          "ring.toml:17:7: time.end must be a number in s"}) {
    CHECK_THAT(all, Contains(one));
  }
  CHECK_THAT(all, !Contains("grid.cell is missing"));  // it is what the misspelt key stands for
}

TEST_CASE("of many mistakes twenty are told, and how many more there are") {
  std::string bodies;
  for (int k = 0; k < 25; ++k) {
    bodies += "[[bodies]]\nrandom = 1\nmaterial = []\n";
  }
  const std::string all = error_of(replaced(ring, "[heat]\n", bodies + "[heat]\n"));
  CHECK(std::count(all.begin(), all.end(), '\n') == 20);
  CHECK_THAT(all, Contains("and 30 more"));
}

TEST_CASE("a key that was renamed names its successor") {
  const std::string text =
      replaced(ring, "[heat]\n", "[[monitors]]\nname = \"mid\"\nposition = [3, 0]\n[heat]\n");
  CHECK_THAT(error_of(text), Contains("ring.toml:10:3: monitors is called 'probes' now"));

  struct Renamed {
    const char *heading, *line, *message;
  };
  const auto renamed = GENERATE(values<Renamed>({
      {"[momentum]", "", "momentum is called 'dynamics' now"},
      {"[[dynamics.walls]]", "kind = \"no_slip\"\nface = \"y_lower\"",
       "dynamics.walls is called 'grid_boundaries' now"},
      {"[dynamics]", "step_safety = 0.5", "dynamics.step_safety is called 'courant' now"},
      {"[dynamics]", "pic_share = 0.1", "dynamics.pic_share is called 'pic_fraction' now"},
      {"[[quasi_static.walls]]", "kind = \"fixed\"", "quasi_static.walls is called 'supports' now"},
      {"[quasi_static]", "wall_form = \"nitsche\"",
       "quasi_static.wall_form is called 'enforcement' now"},
      {"[quasi_static]", "ghost = 0.1", "quasi_static.ghost is called 'ghost_penalty' now"},
      {"[quasi_static]", "largest_halvings = 3",
       "quasi_static.largest_halvings is called 'max_cutbacks' now"},
  }));
  CHECK_THAT(error_of(replaced(ring, "[heat]\n",
                               message(renamed.heading, "\n", renamed.line, "\n[heat]\n"))),
             Contains(renamed.message));
  CHECK_THAT(error_of(replaced(ring, "\"nodal\"", "\"kept\"")),
             Contains("heat.transfer knows no 'kept'; it is called 'nodal' now"));
  CHECK_THAT(error_of(replaced(ring, "[heat]\n", "[heat]\nstepping = \"theta\"\n")),
             Contains("heat.stepping is called 'time_integration' now"));
}

TEST_CASE("files that are none are named") {
  CHECK_THROWS_WITH(load_scene("/nowhere/ring.toml"), Contains("there is no such file"));
  CHECK_THROWS_WITH(load_scene("/tmp"), Contains("not a regular file"));
}

TEST_CASE("a function can be in a scene, not in a file") {
  Scene scene = parse_scene(ring, "ring.toml");
  std::get<Convection>(scene.heat->boundaries[0]).ambient = Value(ArrayFunction(
      [](std::span<const Vec3>, std::span<const double>, double, std::span<double>) {}));
  CHECK_THROWS_WITH(to_toml(scene), Contains("heat.boundaries[0].ambient is given as function"));
  CHECK_THAT(to_json(scene), Contains("\"ambient\": \"function\""));
  scene = parse_scene(ring, "ring.toml");
  scene.bodies[0].points = GivenPoints{};
  CHECK_THROWS_WITH(to_toml(scene), Contains("bodies[0].points is given as arrays"));
}

TEST_CASE("one member is set by its path") {
  Scene scene = parse_scene(ring, "ring.toml");
  apply_override(scene, "grid.cell=0.05");
  CHECK(scene.grid.cell == 0.05);
  apply_override(scene, "bodies.0.points_per_cell = 9");
  CHECK(scene.bodies[0].points_per_cell == 9);
  apply_override(scene, "bodies.0.shape.inner=.5");
  CHECK(std::get<Annulus>(*scene.bodies[0].shape).inner == 0.5);
  apply_override(scene, "bodies[0].material.density=2");
  CHECK(std::get<Thermal>(scene.bodies[0].material[0]).density == 2.0);
  apply_override(scene, "heat.transfer=flip");
  CHECK(scene.heat->transfer == HeatTransfer::flip);
  apply_override(scene, "heat.boundaries.0.region={kind = \"disk\", radius = 2}");
  CHECK(std::get<Disk>(*std::get<Convection>(scene.heat->boundaries[0]).region).radius == 2.0);
  apply_override(scene, "time.step=0.001");
  CHECK(scene.time.step == 0.001);
  apply_override(scene, "time.step=auto");
  CHECK_FALSE(scene.time.step);
  scene.heat.reset();
  apply_override(scene, "heat.theta=1");
  CHECK(scene.heat->theta == 1.0);
}

TEST_CASE("an override that is wrong leaves the scene as it was") {
  struct Mistake {
    const char *assignment, *message;
  };
  const auto mistake = GENERATE(
      Mistake{"grid.cel=0.05", "--set: grid.cel is no known key; did you mean 'cell'?"},
      Mistake{"grid.cell=-1", "--set: grid.cell must be above 0 (m), got -1"},
      Mistake{"grid.cell=fine", "--set: grid.cell must be a number in m, got the text \"fine\""},
      Mistake{"grid.cell", "--set needs key=value, got \"grid.cell\""},
      Mistake{"grid.cell=", "--set: the value is missing"},
      Mistake{"grid.cell=1\nevil=2", "--set: the value is not valid TOML"},
      Mistake{"grid.cell.fine=1", "grid.cell has no parts"},
      Mistake{"bodies[1].jitter=0.1",
              "bodies[1] does not exist: bodies has 1 entries, counted from 0"},
      Mistake{"bodies[0].shape.kind=disk", "bodies[0].shape.kind cannot change alone"},
      Mistake{"bodies[0].motion.velocity=[1]", "bodies[0].motion.kind is missing"},
      Mistake{"=1", "--set needs key=value"}, Mistake{".=1", "is no known key"});
  Scene scene = parse_scene(ring, "ring.toml");
  CHECK_THROWS_WITH(apply_override(scene, mistake.assignment), Contains(mistake.message));
  CHECK(to_toml(scene) == to_toml(parse_scene(ring, "ring.toml")));
}
