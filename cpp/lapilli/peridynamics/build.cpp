#include "lapilli/peridynamics/build.hpp"

#include <algorithm>
#include <string>
#include <type_traits>

#include "lapilli/core/allowed.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/peridynamics/flow.hpp"
#include "lapilli/peridynamics/heat.hpp"

namespace lapilli {
namespace {

/// Visitor that holds every number to the range its key allows.
struct CheckRanges {
  std::string where;

  template <class Member>
  void operator()(const Key& key, const Member& value) const {
    if constexpr (std::is_same_v<Member, double>) {
      check_range(key, value, where);
    }
  }
};

void check_horizon(const char* name, double horizon, double spacing) {
  require(horizon > 1.0, "the ", name, " horizon of ", horizon * spacing,
          " m is not above the spacing of ", spacing, " m: no point would have a family");
}

void check_length(const std::vector<double>& given, int dimension, const std::string& what) {
  require(given.empty() || static_cast<int>(given.size()) == dimension, what, " has ", given.size(),
          " numbers in a scene of dimension ", dimension);
}

/// Hold the settings and materials of heat to what they may be; returns its widest horizon, m.
double check_heat(const PeridynamicScene& scene, const PeridynamicHeatSettings& settings) {
  check_horizon("thermal", settings.widest_horizon(), scene.spacing);
  const CheckRanges ranges{"heat"};
  PeridynamicHeatSettings::describe(*scene.heat, ranges);
  const Thermal& thermal = scene.fluid.thermal;
  check(thermal);
  require(!thermal.varies(),
          "the thermal material must not depend on the temperature or melt in [peridynamics]");
  require(thermal.conductivity.constant().is_scalar(),
          "peridynamic heat conducts alike in all directions: give conductivity as a number");
  require(!scene.heat->viscous_dissipation || scene.flow,
          "heat.viscous_dissipation needs a flow; this scene has none");
  return settings.widest_horizon() * scene.spacing;
}

/// The same for the flow.
double check_flow(const PeridynamicScene& scene, int dimension) {
  const Fluid& fluid = scene.fluid;
  check_horizon("fluid", scene.flow->horizon, scene.spacing);
  const CheckRanges ranges{"flow"};
  PeridynamicFlowSettings::describe(*scene.flow, ranges);
  check(fluid.newtonian);
  check_length(scene.flow->gravity, dimension, "flow.gravity");
  require(scene.heat || fluid.newtonian.thermal_expansion == 0.0,
          "thermal_expansion of the newtonian material is given, but the scene has no heat");
  require(!scene.heat || fluid.thermal.density == fluid.newtonian.density,
          "the fluid has two densities: ", fluid.thermal.density, " of the thermal and ",
          fluid.newtonian.density, " kg/m^3 of the newtonian material");
  return scene.flow->horizon * scene.spacing;
}

}  // namespace

std::vector<std::unique_ptr<Physics>> build_peridynamics(Points& points,
                                                         const PeridynamicScene& scene) {
  require(scene.heat || scene.flow,
          "a peridynamic scene models heat, flow or both; this one has neither section");
  const Fluid& fluid = scene.fluid;
  std::optional<PeridynamicHeatSettings> heat_settings = scene.heat;
  if (heat_settings && scene.flow) {
    heat_settings = for_flow(*heat_settings);
  }
  require(scene.spacing > 0.0, "the spacing of peridynamic points must be above 0 m, got ",
          scene.spacing);
  double horizon = 0.0;
  if (scene.heat) {
    horizon = check_heat(scene, *heat_settings);
  }
  if (scene.flow) {
    horizon = std::max(horizon, check_flow(scene, points.dimension()));
  }
  for (const FluidWall& wall : scene.walls) {
    check(wall.settings, points.dimension());
  }

  auto walls = std::make_shared<WallSurface>(points, scene.walls, scene.region, scene.spacing,
                                             scene.wall_shapes);
  if (scene.flow || scene.heat->laplacian != Laplacian::corrected) {
    walls->require_thickness(horizon);  // points at rest need no more than the surface of a wall
  }
  if (scene.flow) {
    walls->require_closed(scene.region);
  }
  std::vector<std::unique_ptr<Physics>> physics;
  PeridynamicHeat* heat = nullptr;
  if (scene.heat) {
    auto made = std::make_unique<PeridynamicHeat>(points, walls, *heat_settings, fluid,
                                                  scene.flow.has_value());
    heat = made.get();
    physics.push_back(std::move(made));
  }
  if (scene.flow) {
    auto made = make_flow(points, walls, *scene.flow, fluid, heat,
                          scene.heat && scene.heat->viscous_dissipation);
    if (heat != nullptr) {
      heat->heat_by(made->dissipation());
      heat->follow_shift(made->shifted());
    }
    physics.push_back(std::move(made));
  }
  return physics;
}

}  // namespace lapilli
