#pragma once

#include "lapilli/peridynamics/flow.hpp"
#include "lapilli/peridynamics/heat.hpp"

namespace lapilli {

/// What a Nusselt number is measured against: conduction alone over `length` m by `range` K.
struct NusseltScale {
  double length = 1.0;  // m, between the walls
  double range = 1.0;   // K, hot minus cold
};

/// Heat carried and conducted along `axis` through a closed fluid layer, over its volume mean, in
/// units of conduction: 1 + <u T> length / (alpha range).
double volume_mean_nusselt(const Points& points, const Flow& flow, const PeridynamicHeat& heat,
                           int axis, const NusseltScale& scale);

/// Heat flow out of `wall` over its area, in units of conduction.
double wall_nusselt(const PeridynamicHeat& heat, int wall, const NusseltScale& scale);

/// Heat flux into the fluid through walls near `place`, W/m^2: the mean over the points that meet
/// them, a Gaussian of `reach` m weighted by area. Call Simulation::fields() before.
double wall_flux_near(const Points& points, const PeridynamicHeat& heat, const Vec3& place,
                      double reach);

/// A quantity of the fluid at `place`: the linear function that fits the fluid points within
/// `reach` m best, weighted by a Gaussian. `values` has `components` a row. Throws
/// std::invalid_argument when too few points are near.
double sample_fluid(const Points& points, const WallSurface& walls, std::span<const double> values,
                    int components, int component, const Vec3& place, double reach);

}  // namespace lapilli
