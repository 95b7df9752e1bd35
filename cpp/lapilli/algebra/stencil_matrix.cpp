#include "lapilli/algebra/stencil_matrix.hpp"

#include <cmath>

namespace lapilli {
namespace {

/// (reach * 2 + 1)^Dim
int block_size(int width, int dimension) {
  int size = 1;
  for (int axis = 0; axis < dimension; ++axis) {
    size *= width;
  }
  return size;
}

}  // namespace

template <int Dim>
StencilMatrix<Dim>::StencilMatrix(const NodeRows<Dim>& rows)
    : rows_(&rows), width_(2 * rows.reach() + 1), centre_((block_size(width_, Dim) - 1) / 2) {
  for (Index number = centre_; number < 2 * centre_ + 1; ++number) {
    std::array<int, Dim> step;
    Index rest = number;
    for (int axis = 0; axis < Dim; ++axis, rest /= width_) {
      step[axis] = static_cast<int>(rest % width_) - rows.reach();
    }
    Index away = 0;
    if constexpr (Dim >= 2) {
      away = step[1];
    }
    if constexpr (Dim == 3) {
      away += step[2] * rows.rows_in_layer();
    }
    later_.push_back({away, step[0]});
  }
  coefficient_.assign(later_.size() * static_cast<std::size_t>(rows.size()), 0.0);
}

template <int Dim>
void StencilMatrix<Dim>::distances(const typename NodeRows<Dim>::Row& row,
                                   std::vector<Index>& later, std::vector<Index>& earlier) const {
  later.resize(later_.size());
  earlier.resize(later_.size());
  for (std::size_t s = 0; s < later_.size(); ++s) {
    later[s] = rows_->distance(row, later_[s].rows_away) + later_[s].step;
    earlier[s] = rows_->distance(row, -later_[s].rows_away) - later_[s].step;
  }
}

template <int Dim>
std::vector<double> StencilMatrix<Dim>::absolute_multiply(std::span<const double> x) const {
  std::vector<double> product(x.size(), 0.0);
  std::vector<Index> later, earlier;
  for (const auto& row : rows_->rows()) {
    distances(row, later, earlier);
    for (Index place = row.shift + row.begin; place < row.shift + row.end; ++place) {
      double sum = std::abs(coefficient_[place]) * x[place];
      for (std::size_t s = 1; s < later_.size(); ++s) {
        const double* c = coefficient_.data() + static_cast<Index>(s) * rows_->size() + place;
        sum +=
            std::abs(c[0]) * x[place + later[s]] + std::abs(c[earlier[s]]) * x[place + earlier[s]];
      }
      product[place] = sum;
    }
  }
  return product;
}

template <int Dim>
void StencilMatrix<Dim>::append_triplets(std::span<const Index> number, double scale,
                                         std::vector<Eigen::Triplet<double>>& triplets) const {
  std::vector<Index> later, earlier;
  for (const auto& row : rows_->rows()) {
    distances(row, later, earlier);
    for (Index place = row.shift + row.begin; place < row.shift + row.end; ++place) {
      if (number[place] < 0) {
        continue;
      }
      for (std::size_t s = 0; s < later_.size(); ++s) {
        const double value = coefficient_[static_cast<Index>(s) * rows_->size() + place];
        const Index other = number[place + later[s]];
        if (value != 0.0 && other >= 0) {
          const auto low = static_cast<int>(std::min(number[place], other));
          const auto high = static_cast<int>(std::max(number[place], other));
          triplets.emplace_back(high, low, scale * value);
        }
      }
    }
  }
}

template class StencilMatrix<1>;
template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace lapilli
