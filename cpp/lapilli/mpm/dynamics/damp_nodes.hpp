#pragma once

#include "lapilli/mpm/dynamics/solve_nodes.hpp"

namespace lapilli {

/// Local non-viscous damping (after Cundall 1987) of the solved nodes: a share of the force that is
/// out of balance acts against the velocity, as far as that takes energy. It belongs to the force,
/// not to the number of steps, and vanishes in equilibrium.
template <int Dim>
void damp_nodes(DynamicsData<Dim>& data, double share, NodeSums& sums);

}  // namespace lapilli
