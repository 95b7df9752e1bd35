#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "lapilli/core/parallel.hpp"

namespace lapilli {

/// Neighbours of nodes in a list that is sorted by their number in a grid.
template <int Dim>
class NodeNeighbours {
 public:
  /// `number`: of each node, ascending; `stride`: of the numbers along each axis, the first is 1.
  NodeNeighbours(std::vector<Index> number, const std::array<Index, Dim>& stride)
      : number_(std::move(number)), stride_(stride), first_(number_.size()) {
    parallel_for(static_cast<Index>(number_.size()), [&](Index k) {
      for (int row = 0; row < rows; ++row) {
        const auto found = std::ranges::lower_bound(number_, lowest(k, row));
        first_[k][row] = static_cast<int>(found - number_.begin());
      }
    });
  }

  /// Sums over a node and its neighbours, each weighed 1/2 for every axis that it is off.
  template <class T>
  std::vector<T> smooth(const std::vector<T>& values) const {
    std::vector<T> result(values.size());
    parallel_for(static_cast<Index>(values.size()), [&](Index k) {
      T sum = T::Zero();
      for (int row = 0; row < rows; ++row) {
        const Index from = lowest(k, row);
        const double across = (row % 3 == 1 ? 1.0 : 0.5) * (Dim == 2 || row / 3 == 1 ? 1.0 : 0.5);
        for (auto at = static_cast<std::size_t>(first_[k][row]);
             at < number_.size() && number_[at] <= from + 2; ++at) {
          sum += across * (number_[at] == from + 1 ? 1.0 : 0.5) * values[at];
        }
      }
      result[k] = sum;
    });
    return result;
  }

 private:
  static constexpr int rows = Dim == 2 ? 3 : 9;

  /// Number of the first of three nodes of a row around node k.
  Index lowest(Index k, int row) const {
    Index number = number_[k] - 1 + (row % 3 - 1) * stride_[1];
    if constexpr (Dim == 3) {
      number += (row / 3 - 1) * stride_[2];
    }
    return number;
  }

  std::vector<Index> number_;
  std::array<Index, Dim> stride_;
  std::vector<std::array<int, rows>> first_;  // in the list, of every row around a node
};

}  // namespace lapilli
