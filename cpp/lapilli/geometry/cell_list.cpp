#include "lapilli/geometry/cell_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

Vec3 place_of(std::span<const double> position, int dimension, Index row) {
  Vec3 at = Vec3::Zero();
  for (int axis = 0; axis < dimension; ++axis) {
    at[axis] = position[static_cast<std::size_t>(row * dimension + axis)];
  }
  return at;
}

// The bin size that leaves at most about four bins a point.
double sparing_size(const Vec3& extent, int dimension, double bin_size, Index rows) {
  const auto count = [&](double size) {
    double bins = 1.0;
    for (int axis = 0; axis < dimension; ++axis) {
      bins *= std::floor(extent[axis] / size) + 1.0;
    }
    return bins;
  };
  const double most = 4.0 * static_cast<double>(rows) + 64.0;
  while (count(bin_size) > most) {
    bin_size *= 1.25;
  }
  return bin_size;
}

}  // namespace

CellList::CellList(std::span<const double> position, int dimension, double bin_size)
    : dimension_(dimension), bin_size_(bin_size) {
  require(dimension >= 1 && dimension <= 3, "a cell list has 1, 2 or 3 dimensions, got ",
          dimension);
  require(std::isfinite(bin_size) && bin_size > 0.0,
          "cell list: bin_size must be positive and finite, got ", bin_size);
  require(position.size() % static_cast<std::size_t>(dimension) == 0,
          "cell list: ", position.size(), " numbers are no whole rows of dimension ", dimension);
  const Index rows = static_cast<Index>(position.size()) / dimension;
  Vec3 upper = Vec3::Zero();
  for (Index row = 0; row < rows; ++row) {
    const Vec3 at = place_of(position, dimension, row);
    require(at.allFinite(), "cell list: the position of point ", row, " is not finite");
    lower_ = row == 0 ? at : Vec3(lower_.cwiseMin(at));
    upper = row == 0 ? at : Vec3(upper.cwiseMax(at));
  }
  bin_size_ = sparing_size(upper - lower_, dimension, bin_size, rows);
  for (int axis = 0; axis < dimension; ++axis) {
    bins_[static_cast<std::size_t>(axis)] =
        static_cast<Index>(std::floor((upper[axis] - lower_[axis]) / bin_size_)) + 1;
  }

  start_.assign(static_cast<std::size_t>(bins_[0] * bins_[1] * bins_[2]) + 1, 0);
  std::vector<std::size_t> bin(static_cast<std::size_t>(rows));
  for (Index row = 0; row < rows; ++row) {
    bin[static_cast<std::size_t>(row)] = index_of(bin_of(place_of(position, dimension, row)));
    ++start_[bin[static_cast<std::size_t>(row)] + 1];
  }
  for (std::size_t k = 1; k < start_.size(); ++k) {
    start_[k] += start_[k - 1];
  }
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  row_.resize(static_cast<std::size_t>(rows));
  position_.resize(position.size());
  for (Index row = 0; row < rows; ++row) {
    const Index k = next[bin[static_cast<std::size_t>(row)]]++;
    row_[static_cast<std::size_t>(k)] = row;
    std::copy_n(position.data() + row * dimension, dimension, position_.data() + k * dimension);
  }
}

CellList::Bin CellList::bin_of(const Vec3& x) const {
  Bin bin{0, 0, 0};
  for (int axis = 0; axis < dimension_; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const double steps = std::floor((x[axis] - lower_[axis]) / bin_size_);
    bin[k] = static_cast<Index>(std::clamp(steps, 0.0, static_cast<double>(bins_[k] - 1)));
  }
  return bin;
}

std::vector<Index> CellList::within(const Vec3& x, double radius) const {
  std::vector<Index> rows;
  each_within(x, radius, [&](Index row, double) { rows.push_back(row); });
  std::sort(rows.begin(), rows.end());
  return rows;
}

Index CellList::nearest(const Vec3& x) const {
  require(x.allFinite(),
          "cell list: the nearest point to a place that is not finite was asked for");
  if (row_.empty()) {
    return -1;
  }
  Vec3 beyond = Vec3::Zero();  // from the bins to x
  for (int axis = 0; axis < dimension_; ++axis) {
    const double upper =
        lower_[axis] + static_cast<double>(bins_[static_cast<std::size_t>(axis)]) * bin_size_;
    beyond[axis] = x[axis] - std::clamp(x[axis], lower_[axis], upper);
  }
  const double outside = beyond.norm();
  for (double margin = 0.5 * bin_size_ + 1e-12 * outside;; margin *= 2.0) {
    const double radius = outside + margin;
    Index best = -1;
    double least = std::numeric_limits<double>::infinity();
    each_within(x, radius, [&](Index row, double squared) {
      if (squared < least || (squared == least && row < best)) {
        least = squared;
        best = row;
      }
    });
    if (best >= 0) {
      return best;
    }
  }
}

NeighbourList neighbours_within(std::span<const double> position, int dimension, double radius) {
  const CellList cells(position, dimension, radius);
  const Index rows = cells.size();
  NeighbourList list;
  list.start.assign(static_cast<std::size_t>(rows) + 1, 0);
  parallel_for(rows, [&](Index row) {
    Index count = -1;  // finds itself
    cells.each_within(place_of(position, dimension, row), radius, [&](Index, double) { ++count; });
    list.start[static_cast<std::size_t>(row) + 1] = count;
  });
  for (std::size_t k = 1; k < list.start.size(); ++k) {
    list.start[k] += list.start[k - 1];
  }
  list.row.resize(static_cast<std::size_t>(list.start.back()));
  parallel_for(rows, [&](Index row) {
    Index* const first = list.row.data() + list.start[static_cast<std::size_t>(row)];
    Index* next = first;
    cells.each_within(place_of(position, dimension, row), radius, [&](Index other, double) {
      if (other != row) {
        *next++ = other;
      }
    });
    std::sort(first, next);
  });
  return list;
}

}  // namespace lapilli
