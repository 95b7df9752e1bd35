#include "lapilli/mpm/heat/plane_stiffness.hpp"

#include <algorithm>

#include "lapilli/core/parallel.hpp"

namespace lapilli {

PlaneStiffness::PlaneStiffness(const Grid<2>& grid) : grid_(grid) {
  const auto cells = static_cast<std::size_t>(grid.node_count());
  for (auto& values : sum_) {
    values.assign(cells, 0.0);
  }
  for (auto& values : flow_) {
    values.assign(cells, 0.0);
  }
}

void PlaneStiffness::clear(Index begin, Index end) {
  for (auto& values : sum_) {
    std::fill(values.begin() + begin, values.begin() + end, 0.0);
  }
}

void PlaneStiffness::conduct(const double* temperature, double* rate, Index begin, Index end) {
  const Index up = grid_.node_stride(1);
  const double per_area = grid_.inverse_cell_size() * grid_.inverse_cell_size();
  // The padding keeps points away from the first and last rows and columns of nodes.
  const Index start = std::max<Index>(0, begin - up - 1);
  const Index last = std::min(end, grid_.node_count() - up - 1);
  parallel_ranges(
      last - start,
      [&](Index from, Index to) {
        const double* t = temperature;
        for (Index cell = start + from; cell < start + to; ++cell) {
          const double both = per_area * sum_[4][cell];
          const double a = sum_[0][cell], b = sum_[1][cell], c = sum_[2][cell], d = sum_[3][cell];
          const double ab = 0.5 * (both - a - b), cd = 0.5 * (both - c - d);
          const double along_lower = t[cell + 1] - t[cell];
          const double along_upper = t[cell + up + 1] - t[cell + up];
          const double along_left = t[cell + up] - t[cell];
          const double along_right = t[cell + up + 1] - t[cell + 1];
          flow_[lower][cell] = a * along_lower + ab * along_upper;
          flow_[upper][cell] = ab * along_lower + b * along_upper;
          flow_[left][cell] = c * along_left + cd * along_right;
          flow_[right][cell] = cd * along_left + d * along_right;
        }
      },
      Work::light);
  const Index first = std::max(begin, up + 1);
  parallel_ranges(
      last - first,
      [&](Index from, Index to) {
        for (Index node = first + from; node < first + to; ++node) {
          rate[node] += flow_[lower][node] - flow_[lower][node - 1] + flow_[upper][node - up] -
                        flow_[upper][node - up - 1] + flow_[left][node] - flow_[left][node - up] +
                        flow_[right][node - 1] - flow_[right][node - up - 1];
        }
      },
      Work::light);
}

}  // namespace lapilli
