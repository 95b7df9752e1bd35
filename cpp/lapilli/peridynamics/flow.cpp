#include "lapilli/peridynamics/flow.hpp"

#include "lapilli/peridynamics/peridynamic_flow.hpp"

namespace lapilli {

std::unique_ptr<Flow> make_flow(Points& points, std::shared_ptr<WallSurface> walls,
                                const PeridynamicFlowSettings& settings, const Fluid& fluid,
                                const PeridynamicHeat* heat, bool with_dissipation,
                                PrintedEquations printed) {
  switch (points.dimension()) {
    case 1:
      return std::make_unique<PeridynamicFlow<1>>(points, std::move(walls), settings, fluid, heat,
                                                  with_dissipation, printed);
    case 2:
      return std::make_unique<PeridynamicFlow<2>>(points, std::move(walls), settings, fluid, heat,
                                                  with_dissipation, printed);
    default:
      return std::make_unique<PeridynamicFlow<3>>(points, std::move(walls), settings, fluid, heat,
                                                  with_dissipation, printed);
  }
}

}  // namespace lapilli
