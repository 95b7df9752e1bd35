#pragma once

#include "lapilli/geometry/fill.hpp"

namespace lapilli {

/// Let every point of less than `share` of a full box (spacing^dimension) join the nearest point
/// within 1.6 spacings that has more: volume and centroid stay those of the body. Points without
/// such a neighbour stay.
void join_small(FilledPoints& points, double share);

}  // namespace lapilli
