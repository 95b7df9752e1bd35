#pragma once

#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// Project mass, momentum (with its affine part) and internal force, - sum V sigma grad S, to the
/// nodes: `mass`, `velocity` (momentum, kg m/s) and `increment` (force, N).
///
/// With the affine transfers points first drift over half the step with the velocity that moved
/// them last. The nodes then act on places in the middle of the step, which carries a constant
/// acceleration exactly and gains no energy in a spin (drift, kick, drift); FLIP moves with the
/// mean velocity instead, which does gain.
template <int Dim>
void project_to_grid(DynamicsData<Dim>& data, double step);

}  // namespace lapilli
