#include <catch2/catch.hpp>

#include "cavity.hpp"

using namespace lapilli;

namespace {

PeridynamicScene scene_of(const cavity::Layout& layout) {
  return {layout.spacing(),          cavity::box_distance(layout),
          cavity::unit_fluid(),      cavity::make_walls(1.0, 0.0),
          PeridynamicHeatSettings{}, PeridynamicFlowSettings{}};
}

std::string refusal(const cavity::Layout& layout, const PeridynamicScene& scene) {
  auto points = cavity::make_points(layout);
  try {
    build_peridynamics(*points, scene);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("bad scenes are refused with the place and the number") {
  using Catch::Contains;
  const cavity::Layout layout{10, 10, 3};
  REQUIRE(refusal(layout, scene_of(layout)) == "accepted");

  PeridynamicScene scene = scene_of(layout);
  scene.heat->horizon = 0.9;
  REQUIRE_THAT(refusal(layout, scene), Contains("thermal horizon of 0.09 m") && Contains("0.1 m"));

  scene = scene_of(layout);
  scene.flow->horizon = 4.015;
  REQUIRE_THAT(refusal(layout, scene),
               Contains("thick at (") && Contains("thinner than the horizon"));
  const cavity::Layout thin{10, 10, 2};
  REQUIRE_THAT(refusal(thin, scene_of(thin)), Contains("at least 3 layers"));

  scene = scene_of(layout);
  scene.region = [](const Vec3& x) { return x[0] - 0.8; };
  REQUIRE_THAT(refusal(layout, scene), Contains("overlaps a wall") && Contains("(0.85, 0.05)"));
  scene.region = [](const Vec3& x) { return x[0] - 1.3; };
  REQUIRE_THAT(refusal(layout, scene), Contains("overlaps the fluid body"));

  scene = scene_of(layout);
  scene.fluid.newtonian.viscosity = -1.0;
  REQUIRE_THAT(refusal(layout, scene), Contains("viscosity") && Contains("got -1"));

  scene = scene_of(layout);
  scene.heat->viscous_dissipation = true;
  scene.flow.reset();
  REQUIRE_THAT(refusal(layout, scene), Contains("needs a flow"));

  scene = scene_of(layout);
  scene.heat.reset();
  scene.flow.reset();
  REQUIRE_THAT(refusal(layout, scene), Contains("neither"));

  scene = scene_of(layout);
  scene.walls[1].body = 1;
  REQUIRE_THAT(refusal(layout, scene), Contains("'right'") && Contains("body of its own"));

  scene = scene_of(layout);
  scene.walls[0].settings.heat = WallHeat::convection;
  REQUIRE_THAT(refusal(layout, scene), Contains("coefficient of 0"));

  scene = scene_of(layout);
  scene.walls[0].settings.velocity = {0.0, 0.0, 1.0};
  REQUIRE_THAT(refusal(layout, scene), Contains("3 numbers"));
}

TEST_CASE("settings of a wall that would do nothing are refused") {
  using Catch::Contains;
  const cavity::Layout layout{10, 10, 3};
  PeridynamicScene scene = scene_of(layout);
  scene.walls[3].settings.flux = 2.0;
  REQUIRE_THAT(refusal(layout, scene), Contains("wall 'top' has a flux") &&
                                           Contains("heat = \"adiabatic\"") &&
                                           Contains("give heat = \"flux\""));
  scene = scene_of(layout);
  scene.walls[3].settings.temperature = 2.0;
  REQUIRE_THAT(refusal(layout, scene), Contains("wall 'top' has a temperature"));
  scene = scene_of(layout);
  scene.walls[0].settings.coefficient = 2.0;
  REQUIRE_THAT(refusal(layout, scene), Contains("wall 'left' has a coefficient"));
  scene = scene_of(layout);
  scene.walls[3].settings.moves = true;
  REQUIRE_THAT(refusal(layout, scene), Contains("needs its velocity"));
}

TEST_CASE("a flow that no wall holds is refused, heat alone is not") {
  using Catch::Contains;
  const cavity::Layout layout{10, 10, 3};
  PeridynamicScene scene = scene_of(layout);
  // The fluid ends at x = 1, its wall begins at 1.2.
  auto points = cavity::make_points(layout);
  for (Index i = 0; i < points->size(); ++i) {
    if (points->body()[i] == 2) {
      points->position()[2 * i] += 0.2;
    }
  }
  REQUIRE_THROWS_WITH(build_peridynamics(*points, scene),
                      Contains("no wall holds the fluid at (0.95, ") &&
                          Contains("0.05 m from its surface") && Contains("free surfaces"));
  scene.flow.reset();
  REQUIRE_NOTHROW(build_peridynamics(*points, scene));
  // Two bodies that touch are one fluid: no wall is asked for between them.
  scene = scene_of(layout);
  scene.region = [&layout](const Vec3& x) {
    const double whole = cavity::box_distance(layout)(x);
    return std::max(whole, -std::abs(x[0] - 0.5));
  };
  REQUIRE(refusal(layout, scene) == "accepted");
}

TEST_CASE("absent physics is absent") {
  const cavity::Layout layout{10, 10, 3};
  PeridynamicScene scene = scene_of(layout);
  scene.flow.reset();
  auto points = cavity::make_points(layout);
  auto physics = build_peridynamics(*points, scene);
  REQUIRE(physics.size() == 1);
  REQUIRE(physics[0]->name() == "heat");
  scene = scene_of(layout);
  scene.heat.reset();
  auto others = cavity::make_points(layout);
  const auto flow = build_peridynamics(*others, scene);
  REQUIRE(flow.size() == 1);
  REQUIRE(flow[0]->name() == "flow");
}
