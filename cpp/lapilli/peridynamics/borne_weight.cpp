#include "lapilli/peridynamics/borne_weight.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

using Values = std::vector<double>;

constexpr double nearest = 0.25;  // spacings: no point is taken to be nearer to a wall

double product(const Values& a, const Values& b) {
  return parallel_sum(static_cast<Index>(a.size()), 0.0, [&](Index i) { return a[i] * b[i]; });
}

}  // namespace

template <int Dim>
BorneWeight<Dim>::BorneWeight(const WallSurface& walls, const Families& families,
                              const Vec<Dim>& gravity)
    : walls_(walls),
      families_(families),
      gravity_(gravity),
      pull_(static_cast<std::size_t>(walls.points().size())),
      surface_(pull_.size(), 0.0) {}

template <int Dim>
void BorneWeight<Dim>::set(Index point, double share) {
  const bool wall = families_.is_wall(point);
  pull_[point] = {wall ? 0.0 : share, gravity_.dot(walls_.points().template position<Dim>(point))};
  surface_[point] = share;
}

template <int Dim>
double BorneWeight<Dim>::mean_share(Index fluid, Index wall) const {
  const double own = pull_[fluid].share, surface = surface_[wall];
  if (std::isnan(surface)) {
    return own;
  }
  const double* place = walls_.points().position().data() + fluid * Dim;
  const double ahead =
      std::max(nearest * walls_.spacing(), walls_.template distance<Dim>(place, wall));
  return own + 0.5 * (1.0 + walls_.depth(wall) / ahead) * (surface - own);
}

template <int Dim>
double BorneWeight<Dim>::of_point(Index point, const double* weights) const {
  const Pull& own = pull_[point];
  const Index begin = families_.begin(point);
  const auto down = [&](Index bond) {
    return weights[bond - begin] * (pull_[families_.neighbour(bond)].potential - own.potential);
  };
  double sum = 0.0;
  if (families_.is_wall(point)) {
    for (Index k = begin; k < families_.wall_begin(point); ++k) {
      const Index fluid = families_.neighbour(k);
      sum += fluid == point ? 0.0 : mean_share(fluid, point) * down(k);
    }
    return sum;
  }
  for (Index k = begin; k < families_.wall_begin(point); ++k) {
    sum += 0.5 * (own.share + pull_[families_.neighbour(k)].share) * down(k);
  }
  for (Index k = families_.wall_begin(point); k < families_.end(point); ++k) {
    sum += mean_share(point, families_.neighbour(k)) * down(k);
  }
  return sum;
}

template <int Dim>
std::vector<double> BorneWeight<Dim>::pressure(std::span<const double> weights,
                                               std::span<const double> volume) const {
  constexpr double tolerance = 1e-6;
  const auto rows = static_cast<Index>(pull_.size());
  Values pressure(pull_.size(), 0.0), residual(pull_.size(), 0.0);
  Values bonds(weights.begin(), weights.end());  // w V V, the same from both ends
  parallel_for(rows, [&](Index i) {
    for (Index k = families_.begin(i); k < families_.end(i); ++k) {
      const bool counts = !families_.is_wall(i) || k < families_.wall_begin(i);
      bonds[k] *= counts ? volume[i] * volume[families_.neighbour(k)] : 0.0;
    }
    residual[i] = -of_point(i, bonds.data() + families_.begin(i));
  });
  double squared = product(residual, residual);
  const double enough = tolerance * tolerance * squared;
  Values direction = residual, pushed(pull_.size(), 0.0);
  for (Index sweep = 0; sweep < rows && squared > enough; ++sweep) {
    parallel_for(rows, [&](Index i) {
      pushed[i] = 0.0;
      for (Index k = families_.begin(i); k < families_.end(i); ++k) {
        pushed[i] += bonds[k] * (direction[i] - direction[families_.neighbour(k)]);
      }
    });
    const double step = squared / product(direction, pushed), before = squared;
    parallel_for(rows, [&](Index i) {
      pressure[i] += step * direction[i];
      residual[i] -= step * pushed[i];
    });
    squared = product(residual, residual);
    parallel_for(rows,
                 [&](Index i) { direction[i] = residual[i] + squared / before * direction[i]; });
  }
  double filled = 0.0, sum = 0.0;
  for (Index i = 0; i < rows; ++i) {
    filled += families_.is_wall(i) ? 0.0 : volume[i];
    sum += families_.is_wall(i) ? 0.0 : volume[i] * pressure[i];
  }
  for (double& one : pressure) {
    one -= sum / filled;
  }
  return pressure;
}

template class BorneWeight<1>;
template class BorneWeight<2>;
template class BorneWeight<3>;

}  // namespace lapilli
