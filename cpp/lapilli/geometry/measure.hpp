#pragma once

#include <functional>

#include "lapilli/geometry/moment_sum.hpp"

namespace lapilli {

/// Moments, about `lower`, of the part of the box [lower, lower + side] where a signed distance is
/// negative. The distance may
/// change by at most the way walked. Exact to rounding in one dimension; where the surface is
/// smooth or flat in the box, Gauss points along all axes but the steepest are exact to about 1e-9
/// of the box in two and 1e-6 in three dimensions; boxes with corners and rims are halved (up to 9
/// times in two, 4 in three dimensions). Parts thinner than 1/32 (1/8 in three
/// dimensions, 1e-6 in one) of a sub-box may be missed.
MomentSum moments_inside(const std::function<double(const Vec3&)>& signed_distance,
                         const Vec3& lower, double side, int dimension);

}  // namespace lapilli
