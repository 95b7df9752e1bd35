#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/peridynamics/flow_settings.hpp"
#include "lapilli/peridynamics/fluid.hpp"
#include "lapilli/peridynamics/heat_settings.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// A peridynamic scene without its points: absent settings are physics that is not modelled.
struct PeridynamicScene {
  double spacing = 0.0;  // m, of the lattice the points were filled from
  /// Signed distance from the region of the fluid, m, positive outside. The fluid should fill it to
  /// half a spacing: where the first points lie a whole spacing off the wall, `corrected`
  /// conduction is short of that layer.
  FluidDistance region;
  Fluid fluid;
  std::vector<FluidWall> walls;  // bodies of `points` that are walls; all others are fluid
  std::optional<PeridynamicHeatSettings> heat;
  std::optional<PeridynamicFlowSettings> flow;
  std::vector<FluidDistance> wall_shapes = {};  // see WallSurface
};

/// The physics of a peridynamic scene, in the order in which they advance: heat, then flow, which
/// moves the points. Walls thick enough for the larger horizon are required.
///
/// Throws std::invalid_argument with the place and the number for settings out of range, a horizon
/// below the spacing, a wall thinner than the horizon, fluid and walls that overlap, a flow that no
/// wall holds, walls or settings that ask for what the scene lacks.
std::vector<std::unique_ptr<Physics>> build_peridynamics(Points& points,
                                                         const PeridynamicScene& scene);

}  // namespace lapilli
