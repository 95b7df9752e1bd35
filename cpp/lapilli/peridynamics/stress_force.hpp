#pragma once

#include <vector>

#include "lapilli/core/large_array.hpp"
#include "lapilli/peridynamics/bond_sums.hpp"

namespace lapilli {

/// Force per volume from the stresses of bonds (Eq. 27): sum of w (S_i + S_j) Y V, S = stress times
/// inverse shape, on top of a viscous force found otherwise.
template <int Dim>
class StressForce {
 public:
  explicit StressForce(Index points);

  /// What one point gives: `stress` is S, at `position` (m); `viscous` a force of its own, N/m^3;
  /// `bonds` the sum of w Y V over its family.
  void set(Index point, const Mat<Dim>& stress, const double* position, const Vec<Dim>& viscous,
           const Vec<Dim>& bonds);
  void add(Index point, const Vec<Dim>& viscous) {
    force_[static_cast<std::size_t>(point)] += viscous;
  }
  /// Force on a point, N/m^3, once all are set; `bond_weight` w V of each bond of the point.
  Vec<Dim> operator()(Index point, const Families& families, const double* bond_weight) const;

 private:
  // 3D: columns of S in quads, then x y z. Otherwise S columnwise, then each coordinate twice, so
  // that one product serves both components of two columns.
  static constexpr Index row_size = Dim == 3 ? 16 : 8;

  LargeArray<double> rows_;
  std::vector<Vec<Dim>> force_, bonds_;
};

}  // namespace lapilli
