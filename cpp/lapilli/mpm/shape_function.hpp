#pragma once

#include <algorithm>
#include <cmath>

#include "lapilli/core/describe.hpp"

namespace lapilli {

/// Which shape function a scene uses. `bspline` is the quadratic one: GIMP of half-width h/2.
enum class ShapeFunction { linear, gimp, bspline };

template <>
struct Names<ShapeFunction> {
  static constexpr std::pair<ShapeFunction, const char*> values[] = {
      {ShapeFunction::linear, "linear"}, {ShapeFunction::gimp, "gimp"}, {ShapeFunction::bspline, "bspline"}};
};

/// Hat functions: two nodes an axis, starting at node `base`.
/// `at` is the position in units of cells from node 0; gradients are per cell (divide by h).
struct LinearShape {
  static constexpr int support = 2;

  static int base(double at) { return static_cast<int>(at); }

  void evaluate(double at, int base, double* value, double* gradient) const {
    const double xi = at - base;
    value[0] = 1.0 - xi;
    value[1] = xi;
    gradient[0] = -1.0;
    gradient[1] = 1.0;
  }
};

/// GIMP (Bardenhagen & Kober 2004, uniform boxes): the hat averaged over [at - l, at + l], three
/// nodes an axis. Branch-free through one clamp; l = 1/2 is the quadratic B-spline.
struct GimpShape {
  static constexpr int support = 3;
  double half_width = 0.25;  // l in cells, in (0, 1/2]

  static int base(double at) { return static_cast<int>(at - 0.5); }

  void evaluate(double at, int base, double* value, double* gradient) const {
    const double d = at - (base + 1);
    const double inside = std::clamp(d, -half_width, half_width);
    const double scale = 0.5 / half_width;
    const double low = half_width - inside, high = half_width + inside;
    value[0] = 0.5 * scale * low * low + std::max(0.0, -half_width - d);
    value[2] = 0.5 * scale * high * high + std::max(0.0, d - half_width);
    value[1] = 1.0 - value[0] - value[2];
    gradient[0] = -scale * low;
    gradient[2] = scale * high;
    gradient[1] = -gradient[0] - gradient[2];
  }
};

}  // namespace lapilli
