#pragma once

#include <cmath>

#include "lapilli/mpm/dynamics/stress_update.hpp"

namespace lapilli {

/// How late friction feels a change of the force across it, s: a wave crosses so many cells of
/// `cell` m meanwhile (Prakash & Clifton 1993; Cochard & Rice 2000, J. Geophys. Res. 105:25891).
/// With Coulomb's law at once, sliding of an elastic body is ill-posed, and a block chatters on its
/// grid. Measured on an obstacle, friction .6: trembling at 1.1, .16, .10, .09 m/s and acceleration
/// wrong by .030, .005, .002, .002 g with 0, 2, 4, 8 cells; more would leave an oblique impact
/// short of its friction.
inline double friction_lag(const StressMaterial& material, double cell) {
  constexpr double lag_cells = 4.0;
  return lag_cells * cell / std::sqrt(material.wave_modulus / material.density);
}

}  // namespace lapilli
