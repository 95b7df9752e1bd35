#pragma once

#include <algorithm>
#include <array>

#include "lapilli/core/vector.hpp"
#include "lapilli/mpm/dynamics/dynamics_settings.hpp"

namespace lapilli {

/// How one face of the grid holds the material.
struct Wall {
  enum class Kind { open, no_slip, roller, frictional };
  Kind kind = Kind::open;
  double friction = 0.0;

  bool is_open() const { return kind == Kind::open; }
};

/// Walls by face: x lower, x upper, y lower, ...
using Walls = std::array<Wall, 6>;

inline Walls walls_of(const DynamicsSettings& settings) {
  Walls walls;
  for (const GridBoundary& wall : settings.grid_boundaries) {
    const auto face = std::visit([](const auto& known) { return known.face; }, wall);
    Wall& held = walls[static_cast<std::size_t>(face)];
    if (const auto* rough = std::get_if<FrictionalBoundary>(&wall)) {
      held = {Wall::Kind::frictional, rough->coefficient};
    } else {
      held.kind =
          std::holds_alternative<NoSlipBoundary>(wall) ? Wall::Kind::no_slip : Wall::Kind::roller;
    }
  }
  return walls;
}

/// Velocity at a wall. `inward` is the sign of the inward normal along `normal`. No-slip stops it,
/// a roller stops it across, a frictional wall stops what moves into it and slows the rest by at
/// most `slows`, m/s: what friction bears, over the mass. A no-slip wall lets go along itself of
/// the share `free`.
template <int Dim>
Vec<Dim> held_by(Wall::Kind kind, int normal, double inward, const Vec<Dim>& velocity,
                 double slows = 0.0, double free = 0.0) {
  if (kind == Wall::Kind::no_slip && free == 0.0) {
    return Vec<Dim>::Zero();
  }
  Vec<Dim> held = velocity;
  held[normal] = 0.0;
  if (kind == Wall::Kind::no_slip) {
    held *= free;
  }
  if (kind == Wall::Kind::frictional) {
    const double slip = held.norm();
    held *= slip > slows ? 1.0 - slows / slip : 0.0;
    held[normal] = std::max(0.0, inward * velocity[normal]) * inward;
  }
  return held;
}

}  // namespace lapilli
