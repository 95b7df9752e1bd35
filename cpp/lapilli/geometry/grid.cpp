#include "lapilli/geometry/grid.hpp"

#include "lapilli/core/require.hpp"

namespace lapilli {

template <int Dim>
Grid<Dim>::Grid(const Vec<Dim>& lower, const Vec<Dim>& upper, double cell_size)
    : lower_(lower), upper_(upper), h_(cell_size), inverse_h_(1.0 / cell_size) {
  require(std::isfinite(cell_size) && cell_size > 0.0, "grid.cell must be positive, got ",
          cell_size);
  require(lower.allFinite() && upper.allFinite(), "grid.lower and grid.upper must be finite");
  node_count_ = cell_count_ = 1;
  for (int axis = 0; axis < Dim; ++axis) {
    const double count = (upper[axis] - lower[axis]) / cell_size;
    require(count > 0.5, "grid.upper must be above grid.lower along axis ", axis, ", got ",
            lower[axis], " and ", upper[axis]);
    require(count < 1e9, "grid has ", count, " cells along axis ", axis, "; at most 1e9");
    require(std::abs(count - std::round(count)) < 1e-6, "grid.upper - grid.lower along axis ", axis,
            " must be a whole number of cells: ", upper[axis] - lower[axis], " m are ", count,
            " cells of ", cell_size, " m");
    cells_[axis] = static_cast<int>(std::lround(count)) + 2 * padding;
    origin_[axis] = lower[axis] - padding * cell_size;
    node_stride_[axis] = node_count_;
    cell_stride_[axis] = cell_count_;
    node_count_ *= cells_[axis] + 1;
    cell_count_ *= cells_[axis];
    require(node_count_ < (Index{1} << 31), "grid has more than 2^31 nodes: take larger cells");
  }
}

template <int Dim>
Vec<Dim> Grid<Dim>::node_position(Index index) const {
  const Cell node = node_at(index);
  Vec<Dim> position;
  for (int axis = 0; axis < Dim; ++axis) {
    position[axis] = lower_[axis] + (node[axis] - padding) * h_;
  }
  return position;
}

template <int Dim>
typename Grid<Dim>::Cell Grid<Dim>::cell_containing(const Vec<Dim>& position) const {
  const Vec<Dim> at = local(position);
  Cell cell;
  for (int axis = 0; axis < Dim; ++axis) {
    cell[axis] = static_cast<int>(std::floor(at[axis]));
  }
  return cell;
}

template <int Dim>
bool Grid<Dim>::contains(const Vec<Dim>& position) const {
  const double slack = 1e-9 * h_;
  for (int axis = 0; axis < Dim; ++axis) {
    if (!(position[axis] >= lower_[axis] - slack && position[axis] <= upper_[axis] + slack)) {
      return false;
    }
  }
  return true;
}

template class Grid<1>;
template class Grid<2>;
template class Grid<3>;

}  // namespace lapilli
