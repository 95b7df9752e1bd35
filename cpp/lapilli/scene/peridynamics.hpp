#pragma once

#include <optional>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/peridynamics/flow_settings.hpp"
#include "lapilli/peridynamics/heat_settings.hpp"
#include "lapilli/peridynamics/wall_settings.hpp"

namespace lapilli {

/// A wall of a peridynamic fluid and the shape whose points it is made of. Draw it as thick as you
/// like: points that no fluid can feel are left out. Where walls overlap the first one counts.
struct FluidWallBody : FluidWallSettings {
  Shape shape;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("shape").required().text("where the wall is, at least a horizon thick"), self.shape);
    FluidWallSettings::describe(self, visit);
  }
};

/// Bodies as points that act on each other at a distance (peridynamics) instead of through a grid.
/// The grid then only says where points lie.
struct PeridynamicsSettings {
  std::optional<PeridynamicHeatSettings> heat;
  std::optional<PeridynamicFlowSettings> flow;
  std::vector<FluidWallBody> walls;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("heat").text("heat on the thermal horizon; absent: not modelled"), self.heat);
    visit(Key("flow").text("viscous flow on the fluid horizon; absent: nothing moves"), self.flow);
    visit(Key("walls").length(0, 10000).text("walls"), self.walls);
  }
};

}  // namespace lapilli
