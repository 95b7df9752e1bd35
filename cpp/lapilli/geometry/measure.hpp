#pragma once

#include <functional>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// The part of an axis-aligned box inside a shape.
struct Part {
  double volume = 0.0;           // m^dimension
  Vec3 centroid = Vec3::Zero();  // undefined where the volume is 0
};

/// Part of the box [lower, lower + side] where a signed distance is negative. The distance may
/// change by at most the way walked. Exact to rounding in one dimension; where the surface is
/// smooth or flat in the box, Gauss points along all axes but the steepest are exact to about 1e-9
/// of the box in two and 1e-6 in three dimensions; boxes with corners and rims are halved (up to 9
/// times in two, 4 in three dimensions). Parts thinner than 1/32 (1/8 in three
/// dimensions, 1e-6 in one) of a sub-box may be missed.
Part part_inside(const std::function<double(const Vec3&)>& signed_distance, const Vec3& lower,
                 double side, int dimension);

}  // namespace lapilli
