#pragma once

#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// New point velocities from the solved nodes, and their momentum projected once more to the
/// `second_velocity` of the nodes (MUSL). Returns the kinetic energy and largest speed.
template <int Dim>
PointSums update_velocities(DynamicsData<Dim>& data, double step);

/// Move the points with the nodal velocity, deform them with the gradient of `strain_velocity`
/// (USL) or `second_velocity` (MUSL), and update stress and volume; under USL also the velocities.
/// With the affine transfers this is the second half of the motion (see project_to_grid).
template <int Dim>
PointSums update_points(DynamicsData<Dim>& data, double step);

}  // namespace lapilli
