#include "lapilli/mpm/dynamics/damp_nodes.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"

namespace lapilli {

template <int Dim>
void damp_nodes(DynamicsData<Dim>& data, double share, NodeSums& total) {
  const Index first = data.nodes.first(), count = data.nodes.last() - first;
  const double* mass = data.nodes.mass();
  const bool limits = data.nodes.limits_strain();
  std::vector<NodeSums> partial(static_cast<std::size_t>((count + piece_rows - 1) / piece_rows));
  parallel_ranges(count, [&](Index begin, Index end) {
    NodeSums& sums = partial[begin / piece_rows];
    for (Index node = first + begin; node < first + end; ++node) {
      if (!(mass[node] > data.empty_node)) {
        continue;
      }
      Vec<Dim> after, change, internal;
      for (int axis = 0; axis < Dim; ++axis) {
        after[axis] = data.nodes.velocity(axis)[node];
        change[axis] = data.nodes.increment(axis)[node];
        internal[axis] = data.nodes.internal(axis)[node];
      }
      // Against the mean velocity of the step, and no more than halts it: it never drives.
      const Vec<Dim> middle = after - 0.5 * change;
      const double speed = middle.norm();
      if (!(speed > 0.0)) {
        continue;
      }
      const Vec<Dim> damping = -std::min(share * change.norm() / speed, 1.0) * middle;
      const Vec<Dim> held = after + damping;
      sums.force_work += 0.5 * mass[node] * internal.dot(damping);
      sums.kinetic_after += 0.5 * mass[node] * (held.squaredNorm() - after.squaredNorm());
      sums.damping += mass[node] * damping.dot(middle + 0.5 * damping);
      for (int axis = 0; axis < Dim; ++axis) {
        sums.damping_impulse[axis] += mass[node] * damping[axis];
        data.nodes.velocity(axis)[node] = held[axis];
        data.nodes.increment(axis)[node] = change[axis] + damping[axis];
        if (limits) {
          data.nodes.strain_velocity(axis)[node] += damping[axis];
        }
      }
    }
  });
  for (const NodeSums& sums : partial) {
    total += sums;
  }
}

template void damp_nodes<2>(DynamicsData<2>&, double, NodeSums&);
template void damp_nodes<3>(DynamicsData<3>&, double, NodeSums&);

}  // namespace lapilli
