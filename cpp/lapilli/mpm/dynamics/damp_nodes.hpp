#pragma once

#include "lapilli/mpm/dynamics/solve_nodes.hpp"

namespace lapilli {

/// Local non-viscous damping (Cundall 1987) of the accelerated nodes: a share of the force that is
/// out of balance acts against the velocity, along every axis. It belongs to the force, not to
/// the number of steps, and vanishes in equilibrium.
template <int Dim>
void damp_nodes(DynamicsData<Dim>& data, double share, double step, NodeSums& sums);

}  // namespace lapilli
