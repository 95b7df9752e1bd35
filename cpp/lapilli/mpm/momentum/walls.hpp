#pragma once

#include "lapilli/mpm/momentum/momentum_settings.hpp"

namespace lapilli {

/// Velocity at a wall. `inward` is the sign of the inward normal along `normal`. No-slip stops it,
/// a roller stops it across, a frictional wall stops what moves into it and slows the rest by at
/// most friction times the velocity it stopped (Coulomb, for impulses).
template <int Dim>
Vec<Dim> held_by(const Wall& wall, int normal, double inward, const Vec<Dim>& velocity) {
  if (wall.kind == WallKind::no_slip) {
    return Vec<Dim>::Zero();
  }
  Vec<Dim> held = velocity;
  const double into = -inward * velocity[normal];
  if (wall.kind == WallKind::roller) {
    held[normal] = 0.0;
  } else if (wall.kind == WallKind::frictional && into > 0.0) {
    held[normal] = 0.0;
    const double slip = held.norm();
    held *= slip > wall.friction * into ? 1.0 - wall.friction * into / slip : 0.0;
  }
  return held;
}

}  // namespace lapilli
