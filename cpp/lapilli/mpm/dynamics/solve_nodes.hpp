#pragma once

#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/obstacles/freed_nodes.hpp"
#include "lapilli/mpm/dynamics/wall_friction.hpp"

namespace lapilli {

/// What the solution of the nodes did to the account of a step.
struct NodeSums {
  double kinetic_before = 0.0;       // J, of the projected momentum
  double kinetic_after = 0.0;        // J
  double force_work = 0.0;           // J done by the nodal forces, walls and gravity left out
  double friction = 0.0;             // J done by walls along themselves (negative)
  double impact = 0.0;               // J done by walls across themselves
  double damping = 0.0;              // J done by local damping (negative)
  Vec3 wall_impulse = Vec3::Zero();  // N s given by walls
  Vec3 damping_impulse = Vec3::Zero();

  NodeSums& operator+=(const NodeSums& other);
};

/// Velocity of every node that carries mass after `step`, v + dt (f / m + g), nothing held yet; its
/// change goes to `increment`, and to nodes without mass goes zero.
template <int Dim>
NodeSums accelerate_nodes(DynamicsData<Dim>& data, double step);

/// Hold the nodes at walls, and book what the walls did. `friction`: null where no wall has any;
/// `freed`: null without obstacles.
template <int Dim>
void hold_nodes(DynamicsData<Dim>& data, double step, WallFriction<Dim>* friction,
                const FreedNodes<Dim>* freed, NodeSums& sums);

/// What the solved nodes hand to points under the blend, once nothing changes their velocity any
/// more: `fade` becomes a share, `gain` follows.
template <int Dim>
void blend_nodes(DynamicsData<Dim>& data, double step);

/// Divide the momentum projected again by the mass (MUSL).
template <int Dim>
void divide_second_velocity(DynamicsData<Dim>& data);

/// Hold the velocity projected again by the walls; the solved one tells what presses them.
template <int Dim>
void hold_second_velocity(DynamicsData<Dim>& data, const FreedNodes<Dim>* freed);

/// The nodal velocity becomes the mean of the step, where points move with that.
template <int Dim>
void take_mean_velocity(DynamicsData<Dim>& data);

}  // namespace lapilli
