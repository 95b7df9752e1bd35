#pragma once

#include "lapilli/core/physics.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/surface_conditions.hpp"

namespace lapilli {

/// Iterations that a nonlinear step of the theta scheme may take.
inline constexpr int theta_iterations = 30;

/// Whether a step is one of the two after the start or after a jump of a table. These are taken as
/// backward Euler halves, which share the matrix of a Crank-Nicolson step and damp what it excites
/// (Rannacher 1984).
inline bool is_damped(double theta, const Step& step, const SurfaceConditions& laws) {
  return theta < 1.0 &&
         (step.index < 2 || laws.jumps_within(step.time - step.size, step.time + step.size));
}

/// The last `change` of an iteration as a share of `scale`, K. Throws RunError where it has not
/// converged.
inline double converged_share(double change, double scale) {
  if (change > 1e-8 * scale) {
    throw RunError(message("heat: the theta scheme stalled after ", theta_iterations,
                           " iterations, change ", change, " K; take smaller steps"));
  }
  return scale > 0.0 ? change / scale : 0.0;
}

}  // namespace lapilli
