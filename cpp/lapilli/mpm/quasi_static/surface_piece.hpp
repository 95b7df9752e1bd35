#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "lapilli/core/in_space.hpp"
#include "lapilli/mpm/quasi_static/surface.hpp"

namespace lapilli {

/// Ends of a straight piece of a surface in the plane, corners of a flat convex one in space.
template <int Dim>
using Piece = std::vector<Vec<Dim>>;

/// Share of the way from `a` to `b` where a function that changes sign is zero (Illinois method).
template <class Function>
double zero_between(const Function& function, double at_a, double at_b) {
  double low = 0.0, high = 1.0, middle = 0.5;
  int side = 0;
  for (int round = 0; round < 60 && high - low > 1e-16; ++round) {
    middle = std::clamp((low * at_b - high * at_a) / (at_b - at_a), low, high);
    const double value = function(middle);
    if (value == 0.0) {
      return middle;
    }
    if ((value > 0.0) == (at_b > 0.0)) {
      high = middle;
      at_b = value;
      at_a *= side == -1 ? 0.5 : 1.0;
      side = -1;
    } else {
      low = middle;
      at_a = value;
      at_b *= side == 1 ? 0.5 : 1.0;
      side = 1;
    }
  }
  return middle;
}

/// The parts of a piece where all regions are positive; values up to `slack` (m) count as zero.
/// Exact where regions have flat faces, with their edges and corners; curved ones within a
/// thousandth of the size of the piece.
template <int Dim>
std::vector<Piece<Dim>> trim_to(Trims regions, const Piece<Dim>& piece, double slack);

/// Add the points of integration of a flat piece with unit normal `normal`: three Gauss points on a
/// segment, seven of degree 5 on a triangle (Radon 1948).
template <int Dim>
void add_points(const Piece<Dim>& piece, const Vec<Dim>& normal,
                std::vector<SurfacePoint<Dim>>& points);

}  // namespace lapilli
