#pragma once

#include <span>

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// rms(v - its weighted mean over the family) / rms(v) over the fluid; 0 at rest. `bond_weight` one
/// a bond.
template <int Dim>
double velocity_noise(const WallSurface& walls, const Families& families,
                      std::span<const double> bond_weight, const PointArray& velocity);

}  // namespace lapilli
