#pragma once

#include <span>
#include <vector>

#include "lapilli/mpm/grid.hpp"

namespace lapilli {

/// A point of integration on a surface.
template <int Dim>
struct SurfacePoint {
  Vec<Dim> position;
  Vec<Dim> normal;  // unit, into the material
  double weight;    // area it stands for
};

/// The part of a surface inside one cell. A surface on a cell face belongs to the cell its normal
/// points into.
template <int Dim>
struct Facet {
  int surface = 0;                       // which one of those that were cut
  typename Grid<Dim>::Cell cell;         //
  std::vector<SurfacePoint<Dim>> points; //

  double area() const {
    double sum = 0.0;
    for (const auto& point : points) {
      sum += point.weight;
    }
    return sum;
  }
  Vec<Dim> centre() const {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const auto& point : points) {
      sum += point.weight * point.position;
    }
    return sum / area();
  }
  Vec<Dim> normal() const {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const auto& point : points) {
      sum += point.weight * point.normal;
    }
    return sum.normalized();
  }
};

/// Cut an open line of points, the material on its left, at every grid line: facets with three Gauss
/// points each, which integrate bilinear products exactly.
std::vector<Facet<2>> cut_line(const Grid<2>& grid, std::span<const Vec<2>> line, int surface);

}  // namespace lapilli
