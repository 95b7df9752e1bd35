#pragma once

#include <vector>

#include "lapilli/peridynamics/fluid_surface.hpp"

namespace lapilli {

/// Of each wall that holds its temperature, about what share of its heat is lost where it ends
/// within a flat side: heat crowds there as one over the root of the distance from the end, which
/// points a spacing apart do not follow. A fifth of a spacing of the wall for each end, measured in
/// two dimensions (Fourier numbers .05 and .3, 10 to 40 points, turned by 0 to 45 degrees: .03 to
/// .38). Ends at corners lose nothing.
std::vector<double> lost_at_ends(const FluidSurface& surface, const WallSurface& walls);

}  // namespace lapilli
