#pragma once

#include <span>
#include <vector>

#include "lapilli/geometry/grid.hpp"
#include "lapilli/mpm/surface/level_set.hpp"

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
  int surface = 0;                        // which one of those that were cut
  typename Grid<Dim>::Cell cell;          //
  std::vector<SurfacePoint<Dim>> points;  //

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

/// Regions, positive inside, outside which a surface does not count.
using Trims = std::span<const LevelSet>;

/// Cut an open line of points, the material on its left, at every grid line: facets with three
/// Gauss points each, which integrate products of bilinear functions exactly. Bends up to 37
/// degrees inside a cell share one facet.
std::vector<Facet<2>> cut_line(const Grid<2>& grid, std::span<const Vec<2>> line, int surface,
                               Trims trims = {});

/// Cut the surface of a level set, positive in the material, at the faces of the cells marked in
/// `cells`. Flat faces, their edges and corners are exact, one facet a face. On curved faces the
/// points of integration lie on the surface and carry its normals; edges of those, and features
/// thinner than an eighth of a cell (a thirty-second in two dimensions), are rounded off.
template <int Dim>
std::vector<Facet<Dim>> cut_level_set(const Grid<Dim>& grid, std::span<const char> cells,
                                      const LevelSet& surface, int number, Trims trims = {});

}  // namespace lapilli
