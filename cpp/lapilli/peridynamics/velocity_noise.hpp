#pragma once

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/influence.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// Velocity with which the points of walls travel, in the mean, m/s: that of a vessel that moves.
template <int Dim>
Vec<Dim> vessel_velocity(const WallSurface& walls);

/// rms(v - its mean over the family, by weight and volume) / rms(v - that of the vessel) over the
/// fluid; 0 at rest.
template <int Dim>
double velocity_noise(const WallSurface& walls, const Families& families, const BondWeight& weight,
                      const PointArray& velocity);

}  // namespace lapilli
