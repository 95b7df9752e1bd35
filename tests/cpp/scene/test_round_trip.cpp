#include <catch2/catch.hpp>

#include "lapilli/scene/scene_file.hpp"
#include "lapilli/scene/tree_writer.hpp"
#include "scene/random_scene.hpp"

using namespace lapilli;

namespace {

// Every member, numbers to the last bit.
Tree everything_in(const Scene& scene) {
  return {TreeWriter(Members::all).write_struct(scene, ""), {}};
}

}  // namespace

TEST_CASE("random scenes are read back to the last bit") {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Scene scene = random_scene(seed);
    for (const Members members : {Members::changed, Members::all}) {
      const std::string text = to_toml(scene, members);
      CAPTURE(seed, text);
      const Scene again = parse_scene(text, "again.toml");
      REQUIRE(same(everything_in(scene), everything_in(again)));
    }
  }
}

TEST_CASE("the comparison of scenes sees the last bit of a number") {
  Scene scene = random_scene(1), other = scene;
  other.grid.cell = std::nextafter(scene.grid.cell, 0.0);
  CHECK_FALSE(same(everything_in(scene), everything_in(other)));
  CHECK(same(everything_in(scene), everything_in(scene)));
}

TEST_CASE("only what differs from the defaults is written") {
  Scene scene;
  scene.grid = {{0.0}, {1.0}, 0.1, ShapeFunction::gimp};
  scene.bodies.resize(1);
  scene.bodies[0].shape = Box{{0.0}, {1.0}};
  scene.bodies[0].material = {Thermal{2.0, 3.0, 4.0, 0.0, {}, {}}};
  scene.heat.emplace();
  scene.time.end = 1.0;
  CHECK(to_toml(scene) == R"(
[grid]
lower = [0.0]
upper = [1.0]
cell = 0.1

[[bodies]]
shape = {kind = "box", lower = [0.0], upper = [1.0]}
material = {kind = "thermal", density = 2.0, specific_heat = 3.0, conductivity = 4.0}

[heat]

[time]
end = 1.0
)");
}
