#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Nodes in a list, sorted by their number in a grid, that lie behind each other along their
/// normals: across a surface, where it lies is one thing for all of them.
template <int Dim>
class SurfaceColumns {
 public:
  /// `number`: of each node, ascending; `stride`: of the numbers along each axis, the first is 1.
  SurfaceColumns(const std::vector<Index>& number, const std::array<Index, Dim>& stride,
                 const std::vector<Vec<Dim>>& normals)
      : members_(number.size()) {
    parallel_for(static_cast<Index>(number.size()), [&](Index k) {
      for (int which = 0; which < block; ++which) {
        Index other = number[k], rest = which;
        Vec<Dim> off;
        for (int axis = 0; axis < Dim; ++axis, rest /= width) {
          off[axis] = static_cast<double>(rest % width - reach);
          other += (rest % width - reach) * stride[axis];
        }
        const double along = off.dot(normals[k]);
        const double aside = std::sqrt(std::max(0.0, off.squaredNorm() - along * along));
        if (aside >= 1.0) {
          continue;
        }
        const auto found = std::ranges::lower_bound(number, other);
        if (found != number.end() && *found == other) {
          members_[k].push_back({static_cast<int>(found - number.begin()), 1.0 - aside});
        }
      }
    });
  }

  /// Sums over the column of each node, members weighed 1 on its line and nothing a cell off it.
  template <class T>
  std::vector<T> add(const std::vector<T>& values) const {
    std::vector<T> result(values.size());
    parallel_for(static_cast<Index>(values.size()), [&](Index k) {
      T sum = T::Zero();
      for (const Member& member : members_[k]) {
        sum += member.weight * values[member.node];
      }
      result[k] = sum;
    });
    return result;
  }

 private:
  struct Member {
    int node = 0;  // in the list
    double weight = 0.0;
  };
  static constexpr int reach = 1, width = 2 * reach + 1;
  static constexpr int block = Dim == 2 ? width * width : width * width * width;

  std::vector<std::vector<Member>> members_;
};

}  // namespace lapilli
