#include "lapilli/mpm/dynamics/contacts/surface_depth.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {
namespace {

constexpr double lowest_mean = -1.5, highest_mean = 0.25;

double weight_of(ShapeFunction shape, double half_width, double distance) {
  if (std::abs(distance) >= 1.5) {
    return 0.0;
  }
  // Of node 3, whatever the lowest one in reach is.
  return with_shape(shape, half_width, [&]<class Shape>(const Shape& one) {
    const double at = 3.0 + distance;
    const int base = Shape::base(at);
    double value[Shape::support], slope[Shape::support];
    one.evaluate(at, base, value, slope);
    return base <= 3 && base + Shape::support > 3 ? value[3 - base] : 0.0;
  });
}

}  // namespace

SurfaceDepth::SurfaceDepth(ShapeFunction shape, double half_width, double spacing) {
  constexpr int samples = 2001;
  constexpr double reach = 1.5;
  std::vector<double> depth, mean;
  double largest = lowest_mean;
  for (int k = 0; k < samples; ++k) {
    const double surface = reach * (2.0 * k / (samples - 1) - 1.0);
    double sum = 0.0, moment = 0.0;
    for (double row = surface - 0.5 * spacing; row > -reach; row -= spacing) {
      const double weight = weight_of(shape, half_width, row);
      sum += weight;
      moment += weight * row;
    }
    if (sum > 1e-12) {
      largest = std::max(largest, moment / sum);
      depth.push_back(surface);
      mean.push_back(largest);
    }
  }
  // Where the mean stands still, the middle of the depths that it belongs to.
  for (int k = 0; k < entries; ++k) {
    const double wanted = lowest_mean + (highest_mean - lowest_mean) * k / (entries - 1);
    const auto place = [&](auto found) {
      const auto index = std::clamp<std::ptrdiff_t>(found - mean.begin(), 0,
                                                    static_cast<std::ptrdiff_t>(mean.size()) - 1);
      return depth[static_cast<std::size_t>(index)];
    };
    depth_.push_back(0.5 * (place(std::ranges::lower_bound(mean, wanted - 1e-9)) +
                            place(std::ranges::upper_bound(mean, wanted + 1e-9))));
  }
}

double SurfaceDepth::operator()(double mean) const {
  const double at = (entries - 1) * (mean - lowest_mean) / (highest_mean - lowest_mean);
  const double inside = std::clamp(at, 0.0, static_cast<double>(entries - 2));
  const auto below = static_cast<std::size_t>(inside);
  const double share = std::min(1.0, at - static_cast<double>(below));
  return depth_[below] + share * (depth_[below + 1] - depth_[below]);
}

}  // namespace lapilli
