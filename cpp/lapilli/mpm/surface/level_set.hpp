#pragma once

#include <cmath>
#include <functional>

#include "lapilli/core/in_space.hpp"

namespace lapilli {

/// A surface as the zero set of a signed distance (m).
struct LevelSet {
  std::function<double(const Vec3&)> distance;
  std::function<Vec3(const Vec3&)> normal;  // gradient of the distance, unit
};

/// The place of a surface nearest to `x` where the distance is true: within `close` (m) of it, or
/// after twelve steps.
template <int Dim, class Surface>
Vec<Dim> foot_of(const Surface& surface, Vec<Dim> x, double close) {
  for (int round = 0; round < 12; ++round) {
    const double distance = surface.distance(in_space<Dim>(x));
    if (std::abs(distance) < close) {
      break;
    }
    x -= distance * surface.normal(in_space<Dim>(x)).template head<Dim>();
  }
  return x;
}

}  // namespace lapilli
