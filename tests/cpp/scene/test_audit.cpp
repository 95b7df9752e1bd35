#include <catch2/catch.hpp>

#include "lapilli/scene/audit.hpp"
#include "lapilli/scene/build.hpp"
#include "lapilli/scene/idle_rules.hpp"
#include "lapilli/scene/keys.hpp"
#include "lapilli/scene/run_scene.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "lapilli/scene/validate.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;

namespace {

const std::string plate = R"(
[grid]
lower = [0, 0]
upper = [4, 2]
cell = 0.5
[[bodies]]
shape = {kind = "box", lower = [0.5, 0.5], upper = [3.5, 1.5]}
material = {kind = "thermal", density = 1, specific_heat = 1, conductivity = 1}
[heat]
[time]
end = 0.1
)";

Scene with(const std::vector<std::string>& changes) {
  Scene scene = parse_scene(plate, "plate.toml");
  for (const std::string& change : changes) {
    apply_override(scene, change);
  }
  return scene;
}

}  // namespace

TEST_CASE("a setting that nothing reads is named with the reason") {
  struct Idle {
    const char *change, *path, *why;
  };
  const auto idle =
      GENERATE(Idle{"heat.theta=1", "heat.theta", "heat.time_integration is not implicit"},
               Idle{"heat.solver=cg", "heat.solver", "explicit steps here, or the step is given"},
               Idle{"heat.tolerance=1e-3", "heat.tolerance", "the step is given"},
               Idle{"heat.surface_fraction=0.4", "heat.surface_fraction", "is not paper"},
               Idle{"heat.blend=2", "heat.blend", "only heat.transfer = affine"},
               Idle{"heat.subcycling=true", "heat.subcycling", "without [dynamics]"},
               Idle{"heat.implicit_robin=false", "heat.implicit_robin", "neither"},
               Idle{"bodies[0].seed=3", "bodies[0].seed", "neither jitter nor random"},
               Idle{"bodies[0].rotation_center=[1, 1]", "bodies[0].rotation_center", "rotated"});
  const std::vector<Note> notes = unused_settings(with({"time.step=1e-5", idle.change}));
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Contains(std::string(idle.path) + " has no effect: "));
  CHECK_THAT(notes[0], Contains(idle.why));
}

TEST_CASE("what may be idle are keys of a scene") {
  for (const IdleRule& rule : idle_rules()) {
    std::string path = rule.pattern;
    for (std::size_t at = path.find("[]"); at != std::string::npos; at = path.find("[]")) {
      path.erase(at, 2);
    }
    const std::size_t dot = path.rfind('.');
    const std::string table = path.substr(0, dot);
    INFO(path);
    CHECK_THAT(keys_as_markdown(table == "bodies.motion" ? "rotation" : table),
               Contains("| `" + path.substr(dot + 1) + "` |"));
  }
}

TEST_CASE("settings that are read are not named") {
  CHECK(unused_settings(with({})).empty());
  CHECK(unused_settings(with({"heat.time_integration=implicit", "heat.theta=1", "heat.solver=cg"}))
            .empty());
  CHECK(unused_settings(with({"heat.solver=cg", "heat.tolerance=1e-3"})).empty());
  CHECK(unused_settings(with({"heat.transfer=affine", "heat.blend=2"})).empty());
  CHECK(unused_settings(with({"bodies[0].jitter=0.1", "bodies[0].seed=3"})).empty());
}

TEST_CASE("a material and a start without their physics are named") {
  Scene scene = with({"bodies[0].temperature=5"});
  scene.heat.reset();
  scene.bodies[0].material.emplace_back(Newtonian{});
  const std::vector<Note> notes = unused_settings(scene);
  REQUIRE(notes.size() == 3);
  CHECK_THAT(notes[0], Contains("bodies[0].temperature has no effect: the scene has no heat"));
  CHECK_THAT(notes[1], Contains("thermal has no effect"));
  CHECK_THAT(notes[2], Contains("newtonian has no effect"));
}

TEST_CASE("a probe must lie in a body and watch a field that there is") {
  Scene scene = with({});
  ProbeSettings probe;
  probe.name = "mid";
  probe.position = {2.0, 1.0};
  scene.probes = {probe};
  CHECK_NOTHROW(build(scene));
  scene.probes[0].position = {3.75, 1.0};
  CHECK_THROWS_WITH(build(scene), Contains("probes[0].position lies 0.25 m outside of every body"));
  scene.probes[0].position = {2.0};
  CHECK_THROWS_WITH(validate(scene), Contains("probes[0].position must have 2 numbers"));
  scene.probes[0] = probe;
  scene.probes[0].field = "temprature";
  CHECK_THROWS_WITH(build(scene), Contains("did you mean 'temperature'"));
  scene.probes = {probe, probe};
  CHECK_THROWS_WITH(validate(scene), Contains("probes[1].name is 'mid' as that of another"));
}
