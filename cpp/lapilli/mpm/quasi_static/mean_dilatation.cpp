#include "lapilli/mpm/quasi_static/mean_dilatation.hpp"

#include <algorithm>

#include "lapilli/mpm/quasi_static/support_terms.hpp"

namespace lapilli {
namespace {

/// Call body(cell, share, middle) for each part of a domain [position - half_width, position +
/// half_width] in one cell of its box; without half-widths the place itself.
template <int Dim, class Body>
void for_each_part(const Grid<Dim>& grid, const CellBox<Dim>& box, const Vec<Dim>& position,
                   const double* half_width, const Body& body) {
  const Vec<Dim> at = grid.local(position);
  for_each_cell(grid, box, [&](Index index) {
    const auto cell = grid.cell_at(index);
    Vec<Dim> middle = at;
    double share = 1.0;
    for (int axis = 0; axis < Dim && half_width != nullptr; ++axis) {
      const double reach = half_width[axis] * grid.inverse_cell_size();
      const double low = std::max(at[axis] - reach, static_cast<double>(cell[axis]));
      const double high = std::min(at[axis] + reach, cell[axis] + 1.0);
      share *= std::max(0.0, high - low) / (2.0 * reach);
      middle[axis] = 0.5 * (low + high);
    }
    body(index, share, Vec<Dim>(grid.origin() + grid.cell_size() * middle));
  });
}

}  // namespace

template <int Dim>
void MeanDilatation<Dim>::build(const Grid<Dim>& grid, std::span<const double> position,
                                std::span<const double> half_width, std::span<const double> volume,
                                std::span<const Index> body, std::span<const char> averaged,
                                const PointWeights<Dim>& weights) {
  start_.clear();
  row_.clear();
  of_point_.clear();
  of_cell_.clear();
  middle_.clear();
  arm_.clear();
  middle_of_point_.clear();
  if (std::none_of(body.begin(), body.end(), [&](Index one) { return averaged[one] != 0; })) {
    return;
  }
  start_.assign(weights.size(), -1);
  Index room = 0;
  for (Index p = 0; p < weights.size(); ++p) {
    if (averaged[body[p]]) {
      start_[p] = room;
      room += weights.node_count(p);
    }
  }
  of_point_.assign(room, Vec<Dim>::Zero());
  const auto each_part = [&](Index p, const auto& visit) {
    const Vec<Dim> place = Eigen::Map<const Vec<Dim>>(position.data() + Dim * p);
    const double* width = half_width.empty() ? nullptr : half_width.data() + Dim * p;
    for_each_part(grid, weights.box(p), place, width, visit);
  };
  average_cells(grid, volume, each_part);
  hand_to_points(grid, weights, each_part);
}

template <int Dim>
template <class EachPart>
void MeanDilatation<Dim>::average_cells(const Grid<Dim>& grid, std::span<const double> volume,
                                        const EachPart& each_part) {
  row_.assign(grid.cell_count(), -1);
  std::vector<double> weight;
  for (Index p = 0; p < static_cast<Index>(start_.size()); ++p) {
    if (start_[p] < 0) {
      continue;
    }
    each_part(p, [&](Index cell, double share, const Vec<Dim>& middle) {
      if (row_[cell] < 0) {
        row_[cell] = static_cast<Index>(weight.size());
        weight.push_back(0.0);
        middle_.push_back(Vec<Dim>::Zero());
        of_cell_.resize(of_cell_.size() + nodes, Vec<Dim>::Zero());
      }
      double value[nodes];
      Vec<Dim> gradient[nodes];
      cell_shape<Dim>(grid, grid.cell_at(cell), middle, value, gradient);
      weight[row_[cell]] += share * volume[p];
      middle_[row_[cell]] += share * volume[p] * middle;
      for (Index a = 0; a < nodes; ++a) {
        of_cell_[row_[cell] * nodes + a] += share * volume[p] * gradient[a];
      }
    });
  }
  for (std::size_t k = 0; k < of_cell_.size(); ++k) {
    of_cell_[k] /= std::max(weight[k / nodes], 1e-300);
  }
  for (std::size_t row = 0; row < middle_.size(); ++row) {
    middle_[row] /= std::max(weight[row], 1e-300);
  }
}

template <int Dim>
template <class EachPart>
void MeanDilatation<Dim>::hand_to_points(const Grid<Dim>& grid, const PointWeights<Dim>& weights,
                                         const EachPart& each_part) {
  arm_.assign(weights.size(), Vec<Dim>::Zero());
  middle_of_point_ = arm_;
  for (Index p = 0; p < weights.size(); ++p) {
    if (start_[p] < 0) {
      continue;
    }
    const CellBox<Dim>& box = weights.box(p);
    each_part(p, [&](Index cell, double share, const Vec<Dim>& middle) {
      arm_[p] += share * (middle - middle_[row_[cell]]);
      middle_of_point_[p] += share * middle_[row_[cell]];
      const auto at = grid.cell_at(cell);
      for (Index a = 0; a < nodes; ++a) {
        of_point_[start_[p] + box.node(at, static_cast<int>(a))] +=
            share * of_cell_[row_[cell] * nodes + a];
      }
    });
  }
}

template class MeanDilatation<2>;
template class MeanDilatation<3>;

}  // namespace lapilli
