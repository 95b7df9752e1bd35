#include "lapilli/mpm/dynamics/damp_nodes.hpp"

#include <cmath>

#include "lapilli/core/parallel.hpp"

namespace lapilli {

template <int Dim>
void damp_nodes(DynamicsData<Dim>& data, double share, double step, NodeSums& total) {
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
      for (int axis = 0; axis < Dim; ++axis) {
        const double after = data.nodes.velocity(axis)[node];
        const double change = data.nodes.increment(axis)[node];
        const double before = after - change;
        if (before == 0.0) {
          continue;
        }
        const double damping = -share * std::copysign(std::abs(change), before);
        const double internal = change - step * data.gravity[axis];
        const double held = after + damping;
        sums.force_work += 0.5 * mass[node] * internal * damping;
        sums.kinetic_after += 0.5 * mass[node] * (held * held - after * after);
        sums.damping += 0.5 * mass[node] * damping * (held + before);
        sums.damping_impulse[axis] += mass[node] * damping;
        data.nodes.velocity(axis)[node] = held;
        data.nodes.increment(axis)[node] = change + damping;
        if (limits) {
          data.nodes.strain_velocity(axis)[node] += damping;
        }
      }
    }
  });
  for (const NodeSums& sums : partial) {
    total += sums;
  }
}

template void damp_nodes<2>(DynamicsData<2>&, double, double, NodeSums&);
template void damp_nodes<3>(DynamicsData<3>&, double, double, NodeSums&);

}  // namespace lapilli
