#include "lapilli/mpm/quasi_static/point_weights.hpp"

#include <algorithm>
#include <numeric>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {
namespace {

template <int Dim>
Vec<Dim> place_of(std::span<const double> position, Index point) {
  return Eigen::Map<const Vec<Dim>>(position.data() + Dim * point);
}

template <int Dim>
void require_inside(const Grid<Dim>& grid, std::span<const double> position) {
  for (Index p = 0; Dim * p < static_cast<Index>(position.size()); ++p) {
    const Vec<Dim> place = place_of<Dim>(position, p);
    if (!grid.contains(place)) {
      throw RunError(message("point in row ", p, " lies outside the grid at ", place.transpose(),
                             " m: enlarge the grid or lower the load"));
    }
  }
}

/// Products of one-dimensional values and gradients over the nodes of a box.
template <int Dim, int Support>
void combine(const CellBox<Dim>& box, const double (&value)[Dim][Support],
             const double (&gradient)[Dim][Support], double inverse_cell, double* values,
             Vec<Dim>* gradients) {
  const int nx = box.cells[0] + 1, ny = box.cells[1] + 1,
            nz = Dim == 3 ? box.cells[Dim - 1] + 1 : 1;
  int k = 0;
  for (int l = 0; l < nz; ++l) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i, ++k) {
        double vz = 1.0, gz = 0.0;
        if constexpr (Dim == 3) {
          vz = value[2][l];
          gz = gradient[2][l];
        }
        values[k] = value[0][i] * value[1][j] * vz;
        gradients[k][0] = gradient[0][i] * value[1][j] * vz * inverse_cell;
        gradients[k][1] = value[0][i] * gradient[1][j] * vz * inverse_cell;
        if constexpr (Dim == 3) {
          gradients[k][2] = value[0][i] * value[1][j] * gz * inverse_cell;
        }
      }
    }
  }
}

}  // namespace

template <int Dim>
void PointWeights<Dim>::build(const Grid<Dim>& grid, std::span<const double> position,
                              std::span<const double> half_width) {
  require_inside(grid, position);
  box_.resize(position.size() / Dim);
  start_.resize(box_.size() + 1);
  if (half_width.empty()) {
    evaluate_linear(grid, position);
  } else {
    evaluate_gimp(grid, position, half_width);
  }
  group_by_box(grid);
}

template <int Dim>
void PointWeights<Dim>::evaluate_linear(const Grid<Dim>& grid, std::span<const double> position) {
  constexpr int nodes = 1 << Dim;
  for (Index p = 0; p <= size(); ++p) {
    start_[p] = p * nodes;
  }
  value_.resize(size() * nodes);
  gradient_.resize(size() * nodes);
  parallel_for(size(), [&](Index p) {
    const Vec<Dim> at = grid.local(place_of<Dim>(position, p));
    double value[Dim][2], gradient[Dim][2];
    for (int axis = 0; axis < Dim; ++axis) {
      box_[p].first[axis] = LinearShape::base(at[axis]);
      box_[p].cells[axis] = 1;
      LinearShape().evaluate(at[axis], box_[p].first[axis], value[axis], gradient[axis]);
    }
    combine<Dim, 2>(box_[p], value, gradient, grid.inverse_cell_size(), value_.data() + start_[p],
                    gradient_.data() + start_[p]);
  });
}

template <int Dim>
void PointWeights<Dim>::evaluate_gimp(const Grid<Dim>& grid, std::span<const double> position,
                                      std::span<const double> half_width) {
  // The box of cells that the domain touches; a domain that ends on a cell face stays before it.
  constexpr double shrink = 1.0 - 1e-9;
  start_[0] = 0;
  for (Index p = 0; p < size(); ++p) {
    const Vec<Dim> at = grid.local(place_of<Dim>(position, p));
    for (int axis = 0; axis < Dim; ++axis) {
      const double reach = half_width[p * Dim + axis] * grid.inverse_cell_size() * shrink;
      box_[p].first[axis] = static_cast<int>(at[axis] - reach);
      box_[p].cells[axis] = static_cast<int>(at[axis] + reach) - box_[p].first[axis] + 1;
    }
    start_[p + 1] = start_[p] + box_[p].node_count();
  }
  value_.resize(start_.back());
  gradient_.resize(start_.back());
  parallel_for(size(), [&](Index p) {
    const Vec<Dim> at = grid.local(place_of<Dim>(position, p));
    double value[Dim][GimpShape::support], gradient[Dim][GimpShape::support];
    for (int axis = 0; axis < Dim; ++axis) {
      const GimpShape shape{half_width[p * Dim + axis] * grid.inverse_cell_size()};
      const int base = GimpShape::base(at[axis]);
      double values[GimpShape::support], gradients[GimpShape::support];
      shape.evaluate(at[axis], base, values, gradients);
      for (int k = 0; k <= box_[p].cells[axis]; ++k) {
        const int node = box_[p].first[axis] + k - base;
        const bool reached = node >= 0 && node < GimpShape::support;
        value[axis][k] = reached ? values[node] : 0.0;
        gradient[axis][k] = reached ? gradients[node] : 0.0;
      }
    }
    combine<Dim, GimpShape::support>(box_[p], value, gradient, grid.inverse_cell_size(),
                                     value_.data() + start_[p], gradient_.data() + start_[p]);
  });
}

template <int Dim>
void PointWeights<Dim>::group_by_box(const Grid<Dim>& grid) {
  const auto cell = [&](const CellBox<Dim>& box) { return grid.cell_index(box.first); };
  order_.resize(box_.size());
  std::iota(order_.begin(), order_.end(), Index{0});
  std::sort(order_.begin(), order_.end(), [&](Index a, Index b) {
    const Index cell_a = cell(box_[a]), cell_b = cell(box_[b]);
    if (cell_a != cell_b) {
      return cell_a < cell_b;
    }
    return box_[a].cells != box_[b].cells ? box_[a].cells < box_[b].cells : a < b;
  });
  groups_.clear();
  bundle_start_.clear();
  int stride = 2;
  for (Index k = 0; k < static_cast<Index>(order_.size()); ++k) {
    const CellBox<Dim>& box = box_[order_[k]];
    if (groups_.empty() || groups_.back().box != box) {
      if (groups_.empty() || groups_.back().box.first != box.first) {
        bundle_start_.push_back(static_cast<Index>(groups_.size()));
      }
      groups_.push_back({box, k, k});
      for (int cells : box.cells) {
        stride = std::max(stride, cells + 1);
      }
    }
    groups_.back().end = k + 1;
  }
  bundle_start_.push_back(static_cast<Index>(groups_.size()));
  colours_.assign(static_cast<std::size_t>(std::pow(stride, Dim) + 0.5), {});
  for (Index bundle = 0; bundle + 1 < static_cast<Index>(bundle_start_.size()); ++bundle) {
    std::size_t colour = 0;
    for (int axis = 0; axis < Dim; ++axis) {
      colour = colour * stride + groups_[bundle_start_[bundle]].box.first[axis] % stride;
    }
    colours_[colour].push_back(bundle);
  }
}

template class PointWeights<2>;
template class PointWeights<3>;

}  // namespace lapilli
