#pragma once

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
/// most friction times the velocity it stopped (Coulomb, for impulses).
template <int Dim>
Vec<Dim> held_by(const Wall& wall, int normal, double inward, const Vec<Dim>& velocity) {
  if (wall.kind == Wall::Kind::no_slip) {
    return Vec<Dim>::Zero();
  }
  Vec<Dim> held = velocity;
  const double into = -inward * velocity[normal];
  if (wall.kind == Wall::Kind::roller) {
    held[normal] = 0.0;
  } else if (wall.kind == Wall::Kind::frictional && into > 0.0) {
    held[normal] = 0.0;
    const double slip = held.norm();
    held *= slip > wall.friction * into ? 1.0 - wall.friction * into / slip : 0.0;
  }
  return held;
}

}  // namespace lapilli
