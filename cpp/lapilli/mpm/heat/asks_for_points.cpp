#include "lapilli/mpm/heat/asks_for_points.hpp"

namespace lapilli {

bool asks_for_points(const HeatSettings& settings) {
  const HeatSettings usual;
  return settings.normal_smoothing != usual.normal_smoothing ||
         settings.corner_fit != usual.corner_fit ||
         settings.implicit_robin != usual.implicit_robin ||
         settings.method != FluxMethod::virtual_flux ||
         (settings.transfer != HeatTransfer::automatic && settings.transfer != HeatTransfer::nodal);
}

}  // namespace lapilli
