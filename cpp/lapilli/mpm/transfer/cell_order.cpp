#include "lapilli/mpm/transfer/cell_order.hpp"

#include <atomic>
#include <numeric>

#include "lapilli/core/require.hpp"

namespace lapilli {

template <int Dim>
CellOrder<Dim>::CellOrder(const Grid<Dim>& grid, int support)
    // With a layer of drift, a strip of n layers touches nodes from -1 to n + support - 1 (one more
    // in 1D, where rows of four lie across the strips); n = support + 1 keeps strips of one parity
    // apart.
    : grid_(grid), support_(support), layers_(support + (Dim == 1 ? 2 : 1)) {
  const int strips = (grid.cells(Dim - 1) + layers_ - 1) / layers_;
  begin_.assign(static_cast<std::size_t>(strips) + 1, 0);
}

template <int Dim>
void CellOrder<Dim>::update(Points& points) {
  if (points.version() == version_ && points.ordering() == ordering_) {
    return;
  }
  if (!still_valid(points)) {
    require_inside(grid_, points);
    sort(points);
  }
  version_ = points.version();
  ordering_ = points.ordering();
}

template <int Dim>
bool CellOrder<Dim>::still_valid(const Points& points) const {
  if (!covers(points)) {
    return false;
  }
  // Bounds repeat with the coordinates; twelve of them hold whole points in any dimension.
  constexpr int period = 12;
  const double slack = 1e-9 * grid_.cell_size();
  std::atomic<bool> valid{true};
  parallel_tasks(strip_count(), [&](Index strip) {
    double lower[period], upper[period];
    for (int k = 0; k < period; ++k) {
      lower[k] = grid_.lower()[k % Dim] - slack;
      upper[k] = grid_.upper()[k % Dim] + slack;
      if (k % Dim == Dim - 1) {
        const double origin = grid_.origin()[Dim - 1] + shift() * grid_.cell_size();
        const auto first = static_cast<double>(strip * layers_ - 1);
        const auto last = static_cast<double>((strip + 1) * layers_ + 1);
        lower[k] = std::max(lower[k], origin + first * grid_.cell_size());
        upper[k] = std::min(upper[k], origin + last * grid_.cell_size() - slack);
      }
    }
    const double* x = points.position().data() + begin_[strip] * Dim;
    const double* end = points.position().data() + begin_[strip + 1] * Dim;
    int outside = 0;
    for (; x + period <= end; x += period) {
      for (int k = 0; k < period; ++k) {
        outside |= !(x[k] >= lower[k]) | !(x[k] <= upper[k]);
      }
    }
    for (int k = 0; x + k < end; ++k) {
      outside |= !(x[k] >= lower[k]) | !(x[k] <= upper[k]);
    }
    if (outside != 0) {
      valid.store(false, std::memory_order_relaxed);
    }
  });
  return valid.load();
}

template <int Dim>
void CellOrder<Dim>::sort(Points& points) {
  const Index count = points.size();
  std::vector<Index> cell(static_cast<std::size_t>(count));
  parallel_for(count, [&](Index row) {
    const Vec<Dim> at = grid_.local(points.position<Dim>(row));
    typename Grid<Dim>::Cell lowest;
    for (int axis = 0; axis < Dim; ++axis) {
      lowest[axis] = static_cast<int>(at[axis] - shift());
    }
    cell[row] = grid_.cell_index(lowest);
  });
  std::vector<Index> next(static_cast<std::size_t>(grid_.cell_count()) + 1, 0);
  for (Index row = 0; row < count; ++row) {
    ++next[cell[row] + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  const Index strip_cells = layers_ * (grid_.cell_count() / grid_.cells(Dim - 1));
  for (Index strip = 0; strip <= strip_count(); ++strip) {
    begin_[strip] = next[std::min(strip * strip_cells, grid_.cell_count())];
  }
  std::vector<Index> order(static_cast<std::size_t>(count));
  bool sorted = true;
  for (Index row = 0; row < count; ++row) {
    const Index place = next[cell[row]]++;
    order[place] = row;
    sorted = sorted && place == row;
  }
  if (!sorted) {
    points.permute(order);
  }
}

template <int Dim>
std::pair<int, int> CellOrder<Dim>::node_layers() const {
  Index first = 0, last = strip_count();
  while (first < last && begin_[first + 1] == begin_[first]) {
    ++first;
  }
  while (last > first && begin_[last] == begin_[last - 1]) {
    --last;
  }
  const int from = static_cast<int>(first) * layers_ - 1;
  const int to = static_cast<int>(last) * layers_ + 6;
  return {std::max(0, from), std::min(grid_.nodes(Dim - 1), to)};
}

template <int Dim>
void CellOrder<Dim>::save(Archive& archive, const std::string& name) const {
  archive.write(name, std::span<const Index>(begin_));
}

template <int Dim>
void CellOrder<Dim>::load(const Archive& archive, const std::string& name) {
  archive.read(name, std::span<Index>(begin_));
}

template <int Dim>
void require_inside(const Grid<Dim>& grid, const Points& points) {
  for (Index row = 0; row < points.size(); ++row) {
    const Vec<Dim> x = points.position<Dim>(row);
    if (!grid.contains(x)) {
      throw RunError(
          message("point ", points.id()[row], " of body ", points.body()[row],
                  x.allFinite() ? " left the grid" : " has a position that is not finite",
                  ", position (", x.transpose(), "), grid (", grid.lower().transpose(), ") to (",
                  grid.upper().transpose(), ")"));
    }
  }
}

template class CellOrder<1>;
template class CellOrder<2>;
template class CellOrder<3>;
template void require_inside(const Grid<1>&, const Points&);
template void require_inside(const Grid<2>&, const Points&);
template void require_inside(const Grid<3>&, const Points&);

}  // namespace lapilli
