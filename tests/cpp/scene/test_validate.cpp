#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/keys.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "lapilli/scene/validate.hpp"
#include "scene/example_scenes.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

struct Mistake {
  const char *from, *to, *message;
};

double total(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

}  // namespace

TEST_CASE("keys that contradict each other are named with their line") {
  const auto mistake = GENERATE(
      Mistake{"[5.6, 5.6]", "[5.6]", "ring.toml:5:1: grid.upper must have as many numbers"},
      Mistake{"[5.6, 5.6]", "[5.6, -6]", "ring.toml:5:1: grid.upper must be above grid.lower"},
      Mistake{"end = 1", "end = 1\nstep = 0.1\nsteps = 3", "time.steps contradicts time.step"},
      Mistake{"end = 1", "end = 1\n[output]\npath = \"ring.h5\"",
              "output.path must end in .vtkhdf"},
      Mistake{"name = \"ring\"", "translation = [1]", "bodies[0].translation must have 2 numbers"},
      Mistake{"name = \"ring\"", "motion = {kind = \"translation\", velocity = [1]}",
              "bodies[0].motion.velocity must have 2 numbers"},
      Mistake{"name = \"ring\"", "rotation_axis = [0, 0, 0]", "must have a length above 0"},
      Mistake{"conductivity = 1", "conductivity = -1", "bodies[0].material: "});
  const Scene scene = parse_scene(replaced(ring_scene, mistake.from, mistake.to), "ring.toml");
  const std::string message = error_of([&] { validate(scene); });
  CHECK_THAT(message, Contains(mistake.message));
  CHECK_THAT(message, StartsWith("ring.toml:"));
}

TEST_CASE("numbers set by a program are checked as those of a file") {
  Scene scene = parse_scene(ring_scene, "ring.toml");
  validate(scene);
  scene.grid.cell = std::nan("");
  CHECK_THROWS_WITH(validate(scene), Contains("grid.cell must be above 0 (m), got nan"));
  scene.grid.cell = 0.4;
  scene.bodies[0].material.clear();
  CHECK_THROWS_WITH(validate(scene), Contains("bodies[0].material must hold 1 to 16 entries"));
  scene.bodies.clear();
  CHECK_THROWS_WITH(validate(scene), Contains("bodies must hold 1 to 1000000 entries"));
}

TEST_CASE("a body is filled, turned and moved to its place") {
  Scene scene =
      parse_scene(replaced(ring_scene, "{kind = \"annulus\", inner = 1, outer = 5}",
                           "{kind = \"box\", lower = [0, 0], upper = [2, 0.8]}\n"
                           "rotation = 90\nrotation_center = [0, 0]\ntranslation = [0.5, 0]"),
                  "box.toml");
  const FilledPoints points = fill_bodies(scene).at(0);
  // 5 x 2 cells of 4 points each; turned by 90 degrees the box is [-0.8, 0] x [0, 2].
  REQUIRE(points.size() == 40);
  CHECK(total(points.volume) == Approx(1.6).epsilon(1e-12));
  double least_x = 9.0, most_y = -9.0;
  for (std::size_t row = 0; row < points.size(); ++row) {
    least_x = std::min(least_x, points.position[2 * row]);
    most_y = std::max(most_y, points.position[2 * row + 1]);
  }
  CHECK(least_x == Approx(-0.8 + 0.1 + 0.5));
  CHECK(most_y == Approx(1.9));
  const Shape placed = *placed_shape(scene.bodies[0]);
  CHECK(distance(placed, Vec3(0.1, 1.0, 0.0)) == Approx(-0.4));
}

TEST_CASE("bodies that cannot be filled are named") {
  const auto mistake =
      GENERATE(Mistake{"outer = 5", "outer = 7", "bodies[0]: reaches out of the grid: "},
               Mistake{"outer = 5", "outer = 0.5", "bodies[0]: "},
               Mistake{"inner = 1, outer = 5", "inner = 0.001, outer = 0.002", "bodies[0]: "},
               Mistake{"shape = {kind = \"annulus\", inner = 1, outer = 5}", "",
                       "bodies[0]: has no points: give a shape"},
               Mistake{"[heat]",
                       "[[bodies]]\nshape = {kind = \"disk\", radius = 2}\nmaterial = {kind = "
                       "\"thermal\", density = 1, specific_heat = 1, conductivity = 1}\n[heat]",
                       "bodies[1] overlaps body 0: its point at "});
  const Scene scene = parse_scene(replaced(ring_scene, mistake.from, mistake.to), "ring.toml");
  const std::string message = error_of([&] { fill_bodies(scene); });
  CHECK_THAT(message, Contains(mistake.message));
  CHECK_THAT(message, Catch::Matchers::Matches("ring\\.toml:[0-9]+:1: bodies\\[[\\s\\S]*"));
}

TEST_CASE("bodies that touch do not overlap") {
  const Scene scene = parse_scene(
      replaced(ring_scene, "[heat]",
               "[[bodies]]\nshape = {kind = \"disk\", radius = 1}\nmaterial = {kind = "
               "\"thermal\", density = 1, specific_heat = 1, conductivity = 1}\n[heat]"),
      "ring.toml");
  CHECK(fill_bodies(scene).size() == 2);
}

TEST_CASE("every key is listed once") {
  const std::string text = keys_as_markdown();
  CHECK_THAT(text, Contains("| `cell` | number | m | above 0 | required | size of a cell |"));
  CHECK_THAT(text, Contains("## `shape annulus`"));
  CHECK_THAT(text, Contains("## `[[heat.boundaries]] convection`"));
  const std::size_t first = text.find("## `shape rotated`");
  CHECK(first != std::string::npos);
  CHECK(text.find("## `shape rotated`", first + 1) == std::string::npos);
}
