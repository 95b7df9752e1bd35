#pragma once

#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// Throws std::invalid_argument for transfers, stress updates and layouts of points that are known
/// to gain energy at every step, however small.
template <int Dim>
void require_stable_choice(const DynamicsData<Dim>& data);

}  // namespace lapilli
