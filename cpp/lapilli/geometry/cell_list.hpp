#pragma once

#include <array>
#include <span>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Uniform bins over a cloud of points, to find the points near a place. Holds a copy of the
/// positions; rows are numbered as they were given. The order of everything found depends on the
/// positions alone.
class CellList {
 public:
  /// `position` is rows x dimension (m); `bin_size` best equals the radius asked for later (larger
  /// bins are taken where the cloud is so sparse that most would be empty).
  /// Throws std::invalid_argument for a bin size that is not positive or a position that is not
  /// finite, naming its row.
  CellList(std::span<const double> position, int dimension, double bin_size);

  Index size() const { return static_cast<Index>(row_.size()); }
  int dimension() const { return dimension_; }
  double bin_size() const { return bin_size_; }
  /// All rows, bin by bin: an order in which neighbours lie close together.
  std::span<const Index> order() const { return row_; }

  /// Call visit(row, squared distance) for each point with |x - point| <= radius, bin by bin and in
  /// ascending rows within a bin; coordinates of `x` past the dimension do not count.
  template <class Visit>
  void each_within(const Vec3& x, double radius, const Visit& visit) const {
    switch (dimension_) {
      case 1:
        return each_within<1>(x, radius, visit);
      case 2:
        return each_within<2>(x, radius, visit);
      default:
        return each_within<3>(x, radius, visit);
    }
  }

  /// The rows within `radius` of `x`, ascending.
  std::vector<Index> within(const Vec3& x, double radius) const;

  /// The row of the point nearest to `x` (the least row of several), -1 without points. Throws
  /// std::invalid_argument if `x` is not finite.
  Index nearest(const Vec3& x) const;

 private:
  using Bin = std::array<Index, 3>;

  Bin bin_of(const Vec3& x) const;
  std::size_t index_of(const Bin& bin) const {
    return static_cast<std::size_t>((bin[2] * bins_[1] + bin[1]) * bins_[0] + bin[0]);
  }
  double squared_distance(Index k, const Vec3& x) const {
    const double* at = position_.data() + k * dimension_;
    double sum = 0.0;
    for (int axis = 0; axis < dimension_; ++axis) {
      sum += (at[axis] - x[axis]) * (at[axis] - x[axis]);
    }
    return sum;
  }
  template <int Dim, class Visit>
  void each_within(const Vec3& x, double radius, const Visit& visit) const;

  int dimension_;
  double bin_size_;
  Vec3 lower_ = Vec3::Zero();
  Bin bins_{1, 1, 1};
  std::vector<Index> start_;      // of each bin, and the end
  std::vector<Index> row_;        // rows, bin by bin
  std::vector<double> position_;  // in the order of row_
};

template <int Dim, class Visit>
void CellList::each_within(const Vec3& x, double radius, const Visit& visit) const {
  // A little more, so that rounding hides no point at exactly the radius.
  const double reach = radius * (1.0 + 1e-12) + 1e-15 * x.cwiseAbs().maxCoeff();
  const Bin low = bin_of(x.array() - reach), high = bin_of(x.array() + reach);
  const double limit = radius * radius;
  // Whether a point is near is anybody's guess: all are written down, the near ones stay.
  constexpr Index most = 64;
  Index near[most];
  double squared[most];
  Bin bin;
  for (bin[2] = low[2]; bin[2] <= high[2]; ++bin[2]) {
    for (bin[1] = low[1]; bin[1] <= high[1]; ++bin[1]) {
      // Bins of one line follow each other.
      bin[0] = low[0];
      const Index from = start_[index_of(bin)];
      bin[0] = high[0];
      const Index to = start_[index_of(bin) + 1];
      for (Index begin = from; begin < to; begin += most) {
        const Index end = begin + most < to ? begin + most : to;
        int count = 0;
        for (Index k = begin; k < end; ++k) {
          const double* at = position_.data() + k * Dim;
          double sum = 0.0;
          for (int axis = 0; axis < Dim; ++axis) {
            sum += (at[axis] - x[axis]) * (at[axis] - x[axis]);
          }
          near[count] = k;
          squared[count] = sum;
          count += sum <= limit ? 1 : 0;
        }
        for (int k = 0; k < count; ++k) {
          visit(row_[static_cast<std::size_t>(near[k])], squared[k]);
        }
      }
    }
  }
}

/// For each row its neighbours, as a compressed list: those of row k are
/// row[start[k]] .. row[start[k + 1] - 1].
struct NeighbourList {
  std::vector<Index> start;  // rows + 1
  std::vector<Index> row;    // ascending for each row

  std::span<const Index> of(Index k) const {
    return std::span(row).subspan(static_cast<std::size_t>(start[k]),
                                  static_cast<std::size_t>(start[k + 1] - start[k]));
  }
};

/// All pairs at most `radius` apart, each seen from both sides, a point not its own neighbour.
NeighbourList neighbours_within(std::span<const double> position, int dimension, double radius);

}  // namespace lapilli
