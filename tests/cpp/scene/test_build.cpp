#include <catch2/catch.hpp>
#include <numeric>

#include "lapilli/scene/build.hpp"
#include "lapilli/scene/check.hpp"
#include "lapilli/scene/run_scene.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "output/scratch_folder.hpp"
#include "scene/example_scenes.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("a built scene runs to its end and keeps its heat") {
  const auto simulation = build(parse_scene(ring_scene, "ring.toml"));
  // 4 points in each of about pi (25 - 1) / h^2 cells, more in those that the rims cut.
  const double asked = 4 * 75.4 / 0.16;
  CHECK(static_cast<double>(simulation->points().size()) >= asked);
  CHECK(static_cast<double>(simulation->points().size()) <= 1.1 * asked);
  simulation->run_until(simulation->end());
  CHECK(simulation->time() == 1.0);
  const std::vector<Field> fields = simulation->fields();
  const auto temperature = std::find_if(
      fields.begin(), fields.end(), [](const Field& field) { return field.name == "temperature"; });
  REQUIRE(temperature != fields.end());
  for (const double value : temperature->values) {
    REQUIRE(value >= -1e-9);
    REQUIRE(value <= 1.0 + 1e-9);
  }
  const Balance heat = simulation->balances().at(0);
  CHECK(std::abs(heat.residual()) < 1e-12);
  // Convection of at most 1 W/m2 on 37.7 m of rim for 1 s.
  CHECK(heat.supplied() > 10.0);
  CHECK(heat.supplied() < 37.7);
}

TEST_CASE("what only a built scene can show is named with its line") {
  struct Mistake {
    const char *from, *to, *message;
  };
  const auto mistake = GENERATE(
      Mistake{"end = 1", "end = 1\nstep = 1.0", "time.step of 1 s is above the limit of "},
      Mistake{"upper = [5.6, 5.6]", "upper = [5.7, 5.6]", "must be a whole number of cells"},
      Mistake{"ambient = 1", "ambient = 1\nregion = {kind = \"disk\", radius = 0.2}",
              "selects no surface"},
      Mistake{"[heat]\n[[heat.boundaries]]\nkind = \"convection\"\ncoefficient = 1\nambient = 1",
              "", "the scene contains no physics"});
  const std::string message = error_of(
      [&] { build(parse_scene(replaced(ring_scene, mistake.from, mistake.to), "ring.toml")); });
  CHECK_THAT(message, Contains(mistake.message));
  CHECK_THAT(message, StartsWith("ring.toml:"));
}

TEST_CASE("a report says what a scene is, models and costs") {
  const Scene scene = parse_scene(ring_scene, "ring.toml");
  const CheckReport report = check(scene);
  const auto simulation = build(scene);
  CHECK(report.dimension == 2);
  CHECK(report.cells == std::vector<Index>{28, 28});
  CHECK(report.nodes == 29 * 29);
  CHECK(report.points == simulation->points().size());
  // The first steps are a sixteenth of what they settle to; those of the whole run are told.
  CHECK(report.step == Approx(16.0 * simulation->next_step_size()));
  CHECK(report.hard_limit >= report.step);
  simulation->run_until(1.0);
  CHECK(std::abs(report.steps - simulation->step_index()) <= 1);
  REQUIRE(report.bodies.size() == 1);
  CHECK(report.bodies[0].spacing == Approx(0.2).epsilon(0.05));  // on the average
  CHECK(report.memory > 0.0);
  CHECK(report.seconds_to_run > 0.0);
  const std::string text = text_of(report);
  CHECK_THAT(text, Contains("models        heat conduction, convection"));
  CHECK_THAT(text, Contains("ring: "));
  CHECK_THAT(json_of(report), Contains("\"dimension\": 2"));
}

TEST_CASE("a run is known by what shapes its state, not by what it writes") {
  const Scene scene = parse_scene(ring_scene, "ring.toml");
  Scene longer = scene, finer = scene;
  longer.time.end = 2.0;
  longer.output.path = "elsewhere.vtkhdf";
  longer.output.every = 0.1;
  finer.grid.cell = 0.2;
  CHECK(run_options(scene).fingerprint == run_options(longer).fingerprint);
  CHECK(run_options(scene).fingerprint != run_options(finer).fingerprint);
}

TEST_CASE("files of a scene are looked for beside it") {
  const testing::ScratchFolder folder;
  testing::put_bytes(folder / "points.csv", "# x y volume\n0.1, 0.1, 0.04\n0.3, 0.1, 0.03\n");
  const std::string with_file =
      replaced(ring_scene, "shape = {kind = \"annulus\", inner = 1, outer = 5}",
               "points_file = \"points.csv\"");
  testing::put_bytes(folder / "scene.toml", with_file);
  const auto simulation = build(load_scene(folder / "scene.toml"));
  REQUIRE(simulation->points().size() == 2);
  CHECK(simulation->points().volume()[1] == 0.03);

  testing::put_bytes(folder / "scene.toml", replaced(with_file, "points.csv", "none.csv"));
  const Scene lost = load_scene(folder / "scene.toml");
  CHECK_THROWS_WITH(build(lost), Contains("scene.toml:7:") && Contains("none.csv"));
  CHECK_THAT(to_toml(lost), Contains("points_file = \"none.csv\""));
}

TEST_CASE("volumes of points that cannot be are refused, those that overlap are named") {
  // The grid holds 121 m^2; four points of the box 2 m x 2 m.
  const auto with_volume = [](double volume) {
    Scene scene = parse_scene(ring_scene, "ring.toml");
    scene.bodies[0].shape.reset();
    scene.bodies[0].points.emplace();
    scene.bodies[0].points->positions = {0.5, 0.5, 1.5, 0.5, 0.5, 1.5, 1.5, 1.5};
    scene.bodies[0].points->volumes.assign(4, volume);
    return scene;
  };
  const auto says_overlap = [&](double volume) {
    const Scene scene = with_volume(volume);
    const auto simulation = build(scene);
    const auto notes = run_options(scene, simulation->points()).notes;
    const bool run_says = std::ranges::any_of(
        notes, [](const std::string& note) { return note.find("overlap") != note.npos; });
    const auto of_check = check(scene).notes;
    const bool check_says = std::ranges::any_of(
        of_check, [](const std::string& note) { return note.find("overlap") != note.npos; });
    CHECK(check_says == run_says);
    return run_says;
  };
  CHECK_FALSE(says_overlap(0.2));
  CHECK_FALSE(says_overlap(1.0));
  CHECK(says_overlap(3.0));
  CHECK_THROWS_WITH(build(with_volume(1e3)),
                    Contains("its points hold 4000 m^2, more than the grid's"));
}

TEST_CASE("an image of a scene file is found from any folder") {
  const testing::ScratchFolder folder;
  testing::put_bytes(folder / "square.pgm", "P2 2 2 1\n1 0\n1 1\n");
  testing::put_bytes(
      folder / "scene.toml",
      replaced(ring_scene, "shape = {kind = \"annulus\", inner = 1, outer = 5}",
               "shape = {kind = \"translated\", by = [0, 0], shape = {kind = \"image\", file = "
               "\"square.pgm\", pixel = 0.8}}"));
  const auto simulation = build(load_scene(folder / "scene.toml"));
  // Three pixels of 2 x 2 cells with 4 points each; corners of a mask are right within a pixel.
  CHECK(simulation->points().size() <= 48);
  CHECK(simulation->points().size() >= 40);
}
