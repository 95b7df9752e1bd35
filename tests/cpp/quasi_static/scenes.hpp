#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/mpm/quasi_static/equilibrium.hpp"

namespace lapilli::test {

/// E = 1000 MPa, nu = 0.3 in N and mm: the material of every case of Cortis et al.
inline const LinearElastic steel{7.85e-9, 1000.0, 0.3};

using Corners = std::vector<Vec<2>>;

/// Keep the part of a polygon where (x - at).normal >= 0.
inline Corners clip(const Corners& polygon, const Vec<2>& at, const Vec<2>& normal) {
  Corners kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec<2>&p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double a = (p - at).dot(normal), b = (q - at).dot(normal);
    if (a >= 0.0) {
      kept.push_back(p);
    }
    if (a * b < 0.0) {
      kept.push_back(p + (q - p) * (a / (a - b)));
    }
  }
  return kept;
}

/// A rectangle with corner `corner`, sides along e1 and e2 = e1 turned by 90 degrees.
struct Rectangle {
  Vec<2> corner, e1, e2;
  double length, height;

  static Rectangle turned(double degrees, Vec<2> at, double along, double across) {
    double c = std::cos(degrees * std::numbers::pi / 180.0);
    double s = std::sin(degrees * std::numbers::pi / 180.0);
    c = std::abs(c) < 1e-15 ? 0.0 : c;
    s = std::abs(s) < 1e-15 ? 0.0 : s;
    return {at, {c, s}, {-s, c}, along, across};
  }
  Vec<2> at(double x, double y) const { return corner + x * e1 + y * e2; }
  Vec<2> local(const Vec<2>& x) const { return {(x - corner).dot(e1), (x - corner).dot(e2)}; }
  Corners corners() const { return {at(0, 0), at(length, 0), at(length, height), at(0, height)}; }
};

/// The grid of cells of size h on multiples of h (plus `origin`) that holds a set of places.
inline Grid<2> grid_around(const Corners& places, double h, double margin = 1.0,
                           Vec<2> origin = Vec<2>::Zero()) {
  Vec<2> low = places[0], high = places[0];
  for (const Vec<2>& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  for (int axis = 0; axis < 2; ++axis) {
    low[axis] = origin[axis] + h * (std::floor((low[axis] - origin[axis]) / h + 1e-9) - margin);
    high[axis] = origin[axis] + h * (std::ceil((high[axis] - origin[axis]) / h - 1e-9) + margin);
  }
  return Grid<2>(low, high, h);
}

/// m x m points a cell, boxes clipped by half-planes (place, inward normal): exact volume, centroid.
/// `relocate` = false leaves the points in the middle of their boxes, which is wrong.
struct HalfPlane {
  Vec<2> at, inward;
};
inline void fill_clipped(Points& points, const Grid<2>& grid, int m,
                         const std::vector<HalfPlane>& sides, bool relocate = true) {
  const double s = grid.cell_size() / m;
  std::vector<double> position, volume;
  for (int j = 0; j < (grid.cells(1) - 6) * m; ++j) {
    for (int i = 0; i < (grid.cells(0) - 6) * m; ++i) {
      const Vec<2> low = grid.lower() + s * Vec<2>(i, j);
      Corners box{low, low + Vec<2>(s, 0), low + Vec<2>(s, s), low + Vec<2>(0, s)};
      bool cut = false, out = false;
      for (const HalfPlane& side : sides) {
        double least = 1e300, most = -1e300;
        for (const Vec<2>& corner : box) {
          const double d = (corner - side.at).dot(side.inward);
          least = std::min(least, d);
          most = std::max(most, d);
        }
        cut = cut || least < -1e-12 * grid.cell_size();
        out = out || most <= 1e-12 * grid.cell_size();
      }
      if (out) {
        continue;
      }
      Vec<2> centre = low + Vec<2>(s / 2, s / 2);
      double area = s * s;
      if (cut) {
        for (const HalfPlane& side : sides) {
          box = clip(box, side.at, side.inward);
        }
        area = 0.0;
        Vec<2> moment = Vec<2>::Zero();
        for (std::size_t k = 0; k < box.size(); ++k) {
          const Vec<2> a = box[k] - box[0], b = box[(k + 1) % box.size()] - box[0];
          const double cross = a[0] * b[1] - a[1] * b[0];
          area += cross / 2;
          moment += cross * (a + b) / 6;
        }
        if (area < 1e-12 * s * s) {
          continue;
        }
        if (relocate) {
          centre = box[0] + moment / area;
        }
      }
      position.insert(position.end(), {centre[0], centre[1]});
      volume.push_back(area);
    }
  }
  points.append(position, volume, 0);
}

}  // namespace lapilli::test
