#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "lapilli/core/describe.hpp"

namespace lapilli {

/// Which shape function a scene uses. `bspline` is the quadratic one: GIMP of half-width h/2.
enum class ShapeFunction { linear, gimp, bspline };

template <>
struct Names<ShapeFunction> {
  static constexpr std::pair<ShapeFunction, const char*> values[] = {
      {ShapeFunction::linear, "linear"},
      {ShapeFunction::gimp, "gimp"},
      {ShapeFunction::bspline, "bspline"}};
};

/// Hat functions: two nodes an axis, starting at node `base`.
/// `at` is the position in units of cells from node 0; gradients are per cell (divide by h).
/// Real is double, or Double4 for four points at once.
struct LinearShape {
  static constexpr int support = 2;
  static constexpr double base_shift = 0.0;  // the lowest node lies at trunc(at - base_shift)

  static int base(double at) { return static_cast<int>(at); }

  void evaluate(double at, int base, double* value, double* gradient) const {
    evaluate(at, static_cast<double>(base), value, gradient);
  }
  template <class Real>
  void evaluate(Real at, Real base, Real* value, Real* gradient) const {
    const Real xi = at - base;
    value[0] = 1.0 - xi;
    value[1] = xi;
    gradient[0] = xi * 0.0 - 1.0;
    gradient[1] = xi * 0.0 + 1.0;
  }
};

/// GIMP (Bardenhagen & Kober 2004, uniform boxes): the hat averaged over [at - l, at + l], three
/// nodes an axis. Branch-free through one clamp; l = 1/2 is the quadratic B-spline.
struct GimpShape {
  static constexpr int support = 3;
  static constexpr double base_shift = 0.5;

  /// `width`: l in cells, in (0, 1/2].
  constexpr explicit GimpShape(double width = 0.25) : half_width(width), scale(0.5 / width) {}

  static int base(double at) { return static_cast<int>(at - base_shift); }

  void evaluate(double at, int base, double* value, double* gradient) const {
    evaluate(at, static_cast<double>(base), value, gradient);
  }
  template <class Real>
  void evaluate(Real at, Real base, Real* value, Real* gradient) const {
    const Real d = at - (base + 1.0);
    const Real inside = clamped(d);
    const Real low = half_width - inside, high = half_width + inside;
    // Beyond the clamp the hat is straight: d - inside is how far beyond.
    const Real beyond = d - inside;
    const Real half = 0.5 * beyond, size = magnitude(half);
    value[0] = 0.5 * scale * low * low + (size - half);
    value[2] = 0.5 * scale * high * high + (size + half);
    value[1] = 1.0 - value[0] - value[2];
    gradient[0] = -scale * low;
    gradient[2] = scale * high;
    gradient[1] = -gradient[0] - gradient[2];
  }

  double half_width;  // l, in cells
  double scale;       // 1 / 2l

 private:
  template <class Real>
  Real clamped(Real d) const {
    if constexpr (std::is_same_v<Real, double>) {
      return std::clamp(d, -half_width, half_width);
    } else {
      const Real upper = d * 0.0 + half_width;
      const Real low = d < -upper ? -upper : d;
      return low > upper ? upper : low;
    }
  }
  template <class Real>
  static Real magnitude(Real x) {
    if constexpr (std::is_same_v<Real, double>) {
      return std::abs(x);
    } else {
      return x < 0.0 ? -x : x;
    }
  }
};

}  // namespace lapilli
