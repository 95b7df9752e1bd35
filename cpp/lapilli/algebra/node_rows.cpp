#include "lapilli/algebra/node_rows.hpp"

#include <algorithm>

namespace lapilli {

template <int Dim>
NodeRows<Dim>::NodeRows(const Grid<Dim>& grid, std::span<const unsigned char> active, int reach)
    : grid_(grid), reach_(reach) {
  const int width = grid.nodes(0);
  const Index row_count = grid.node_count() / width;
  std::vector<std::pair<int, int>> span(static_cast<std::size_t>(row_count), {width, 0});
  for (Index row = 0; row < row_count; ++row) {
    for (int i = 0; i < width; ++i) {
      if (active[row * width + i] != 0) {
        span[row].first = std::min(span[row].first, i);
        span[row].second = i + 1;
      }
    }
  }
  // A row must have room wherever an active row within reach looks at it.
  auto room = span;
  const Index layer = Dim == 3 ? grid.nodes(1) : row_count;  // rows in a layer
  const int reach_up = Dim == 3 ? reach : 0, reach_across = Dim >= 2 ? reach : 0;
  for (Index row = 0; row < row_count; ++row) {
    if (span[row].first >= span[row].second) {
      continue;
    }
    for (int k = -reach_up; k <= reach_up; ++k) {
      for (int j = -reach_across; j <= reach_across; ++j) {
        auto& to = room[row + j + k * layer];
        to.first = std::min(to.first, span[row].first - reach);
        to.second = std::max(to.second, span[row].second + reach);
      }
    }
  }
  shift_.assign(static_cast<std::size_t>(row_count), 0);
  for (Index row = 0; row < row_count; ++row) {
    if (room[row].first >= room[row].second) {
      continue;
    }
    shift_[row] = size_ - room[row].first;
    size_ += room[row].second - room[row].first;
    if (span[row].first < span[row].second) {
      rows_.push_back({row, span[row].first, span[row].second, shift_[row]});
    }
  }
}

template <int Dim>
std::vector<std::array<int, 3>> NodeRows<Dim>::coordinates(std::span<const Index> places) const {
  const Index layer = Dim == 3 ? grid_.nodes(1) : std::max<Index>(1, grid_.node_count());
  std::vector<std::array<int, 3>> all;
  all.reserve(places.size());
  for (const Index place : places) {
    const auto next =
        std::upper_bound(rows_.begin(), rows_.end(), place,
                         [](Index value, const Row& row) { return value < row.shift + row.begin; });
    const Row& row = *std::prev(next);
    all.push_back({static_cast<int>(place - row.shift), static_cast<int>(row.grid_row % layer),
                   static_cast<int>(row.grid_row / layer)});
  }
  return all;
}

template class NodeRows<1>;
template class NodeRows<2>;
template class NodeRows<3>;

}  // namespace lapilli
