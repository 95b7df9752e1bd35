#pragma once

#include <span>

#include "lapilli/geometry/prescribed_motion.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// A rigid map of a body from its place at the start, x = turn X + shift.
struct Placement {
  Mat3 turn = Mat3::Identity();
  Vec3 shift = Vec3::Zero();

  Vec3 operator()(const Vec3& start) const { return turn * start + shift; }
};

/// Whether a motion moves a body as a whole, without shear.
bool is_rigid(const Motion& motion);

/// Where a rigid motion has brought a body at a time. Throws std::invalid_argument for others.
Placement placement_at(const Motion& motion, double time, int dimension);

/// Whether two motions are one and the same.
bool is_same(const Motion& first, const Motion& second);

/// Whether a motion maps a region onto itself at all times: a disk about the axis of a rotation, a
/// half-space along a translation, and what is combined from such; false where that is not known.
bool carries_into_itself(const Motion& motion, const Shape& region, int dimension);

}  // namespace lapilli
