#include "lapilli/mpm/momentum/momentum_settings.hpp"

#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

void check(const MomentumSettings& settings) {
  require(settings.gravity.allFinite(), "momentum.gravity must be finite (m/s2), got ",
          settings.gravity.transpose());
  require(settings.pic_share >= 0.0 && settings.pic_share <= 1.0,
          "momentum.pic_share must lie in [0, 1], got ", settings.pic_share);
  require(settings.step_safety > 0.0 && settings.step_safety <= 1.0,
          "momentum.step_safety must lie in (0, 1], got ", settings.step_safety);
  for (const Wall& wall : settings.walls) {
    require(std::isfinite(wall.friction) && wall.friction >= 0.0,
            "wall friction must not be negative, got ", wall.friction);
    require(wall.friction == 0.0 || wall.kind == WallKind::frictional, "a wall of kind ",
            name_of(wall.kind), " has no friction coefficient, got ", wall.friction,
            "; only frictional walls do");
  }
}

}  // namespace lapilli
