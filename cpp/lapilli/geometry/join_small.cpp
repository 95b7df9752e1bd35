#include "lapilli/geometry/join_small.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapilli/geometry/cell_list.hpp"

namespace lapilli {
namespace {

Vec3 place_of(const FilledPoints& points, std::size_t row) {
  Vec3 at = Vec3::Zero();
  std::copy_n(points.position.data() + row * static_cast<std::size_t>(points.dimension),
              points.dimension, at.data());
  return at;
}

void keep(FilledPoints& points, const std::vector<char>& kept) {
  const auto dimension = static_cast<std::size_t>(points.dimension);
  std::size_t next = 0;
  for (std::size_t row = 0; row < kept.size(); ++row) {
    if (kept[row] != 0) {
      std::copy_n(points.position.data() + row * dimension, dimension,
                  points.position.data() + next * dimension);
      points.volume[next++] = points.volume[row];
    }
  }
  points.position.resize(next * dimension);
  points.volume.resize(next);
}

}  // namespace

void join_small(FilledPoints& points, double share) {
  const double least = share * std::pow(points.spacing, points.dimension);
  const CellList near(points.position, points.dimension, points.spacing);
  std::vector<std::size_t> small;
  for (std::size_t row = 0; row < points.size(); ++row) {
    if (points.volume[row] < least * (1.0 - 1e-9)) {
      small.push_back(row);
    }
  }
  const std::vector<double> first = points.volume;
  std::vector<char> kept(points.size(), 1);
  for (const std::size_t row : small) {
    const Vec3 here = place_of(points, row);
    std::size_t best = row;
    double nearest = 1e300;
    near.each_within(here, 1.6 * points.spacing, [&](Index other, double squared) {
      const auto to = static_cast<std::size_t>(other);
      // Rounding decides nothing between neighbours at the same distance.
      if (first[to] >= least * (1.0 - 1e-9) && squared < nearest * (1.0 - 1e-9)) {
        nearest = squared;
        best = to;
      }
    });
    if (best == row) {
      continue;
    }
    const double part = points.volume[row] / (points.volume[row] + points.volume[best]);
    double* to = points.position.data() + best * static_cast<std::size_t>(points.dimension);
    for (int d = 0; d < points.dimension; ++d) {
      to[d] += part * (here[d] - to[d]);
    }
    points.volume[best] += points.volume[row];
    kept[row] = 0;
  }
  keep(points, kept);
}

}  // namespace lapilli
