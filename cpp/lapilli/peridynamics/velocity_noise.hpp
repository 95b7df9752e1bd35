#pragma once

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/influence.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// rms(v - its mean over the family, by weight and volume) / rms(v) over the fluid; 0 at rest.
template <int Dim>
double velocity_noise(const WallSurface& walls, const Families& families, const BondWeight& weight,
                      const PointArray& velocity);

}  // namespace lapilli
