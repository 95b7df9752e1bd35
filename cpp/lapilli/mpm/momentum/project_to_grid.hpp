#pragma once

#include "lapilli/mpm/momentum/momentum_data.hpp"

namespace lapilli {

/// Project mass, momentum (with its affine part) and internal force, - sum V sigma grad S, to the
/// nodes: `mass`, `velocity` (momentum, kg m/s) and `increment` (force, N).
template <int Dim>
void project_to_grid(MomentumData<Dim>& data);

}  // namespace lapilli
