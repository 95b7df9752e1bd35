#include "lapilli/geometry/come_near.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lapilli/core/vector.hpp"

namespace lapilli {

bool come_near(const Shape& one, const Shape& other, double way, double spacing) {
  const Bounds a = bounds(one), b = bounds(other);
  const Vec3 lower = a.lower.cwiseMax(b.lower) - Vec3::Constant(way);
  const Vec3 span = a.upper.cwiseMin(b.upper) + Vec3::Constant(way) - lower;
  if (span.minCoeff() < 0.0) {
    return false;
  }
  Vec3 from = Vec3::Zero();
  std::array<Index, 3> count{1, 1, 1};  // along axes without an end: the third of a plane
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isfinite(span[axis])) {
      from[axis] = lower[axis];
      count[static_cast<std::size_t>(axis)] = static_cast<Index>(span[axis] / spacing) + 2;
    }
  }
  for (Index k = 0; k < count[0] * count[1] * count[2]; ++k) {
    const Index steps[] = {k % count[0], k / count[0] % count[1], k / count[0] / count[1]};
    const Vec3 place =
        from + spacing * Vec3(static_cast<double>(steps[0]), static_cast<double>(steps[1]),
                              static_cast<double>(steps[2]));
    if (std::max(0.0, distance(one, place)) + std::max(0.0, distance(other, place)) <= way) {
      return true;
    }
  }
  return false;
}

}  // namespace lapilli
