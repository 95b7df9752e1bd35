#pragma once

#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {

/// Give points that go on their mass, velocity, stress and state variables. Throws
/// std::invalid_argument where the other run had no dynamics of this dimension.
template <int Dim>
void go_on(const PointStart& start, DynamicsData<Dim>& data);

}  // namespace lapilli
