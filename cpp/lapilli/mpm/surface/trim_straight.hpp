#pragma once

#include <cmath>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Share of the way, to 1e-12, where a function that is positive at its start ceases to be.
/// Bisection: regions bounded by several surfaces are all but zero on one side, which misleads
/// secants.
template <class Function>
double last_inside(const Function& function) {
  double low = 0.0, high = 1.0;
  for (int round = 0; round < 40; ++round) {
    const double middle = 0.5 * (low + high);
    (function(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The part of a segment or convex polygon where `depth(place)` is positive, up to lines between
/// places on its edges; depths up to `slack` count as zero. Too few corners where there is none.
template <int Dim, class Depth>
std::vector<Vec<Dim>> trim_straight(const std::vector<Vec<Dim>>& corners, const Depth& depth,
                                    double slack) {
  const std::size_t count = corners.size();
  std::vector<double> value(count);
  for (std::size_t k = 0; k < count; ++k) {
    value[k] = depth(corners[k]);
    value[k] = std::abs(value[k]) <= slack ? 0.0 : value[k];
  }
  std::vector<Vec<Dim>> kept;
  const std::size_t sides = Dim == 2 ? count - 1 : count;
  for (std::size_t k = 0; k < count; ++k) {
    if (value[k] >= 0.0) {
      kept.push_back(corners[k]);
    }
    const std::size_t next = (k + 1) % count;
    if (k < sides && value[k] * value[next] < 0.0) {
      const Vec<Dim> along = corners[next] - corners[k];
      const double sign = value[k] < 0.0 ? -1.0 : 1.0;
      kept.push_back(corners[k] + last_inside([&](double share) {
                                    return sign * depth(Vec<Dim>(corners[k] + share * along));
                                  }) * along);
    }
  }
  return kept;
}

}  // namespace lapilli
