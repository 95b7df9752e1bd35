#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/surface/nodal_surface.hpp"
#include "lapilli/mpm/surface/wall_contact.hpp"

namespace lapilli {

// Cells; a region that ends along the surface, less than this below or beyond it, has it.
inline constexpr double region_slack = 0.35;

/// Where the surface lies that a node's area stands for.
template <int Dim>
struct SurfacePlace {
  Vec3 centre;         // m, mean place of the surface, weighted by the node's shape function
  Vec<Dim> direction;  // of the area vector, unit or zero
  Mat<Dim> moment;     // integral of S (x - x_I) n, m^dim; zero where it is not known
  Vec<Dim> width = Vec<Dim>::Ones();  // of the surface that the node stands for, cells
};

/// The place of every node of `areas`: from the first moments of the surface, integral of
/// S (x - x_I) n over it = sum V ((x - x_I) grad S + S 1) over the points, exact where the surface
/// is flat; the projected node where its area is nothing to divide by or was not taken from the
/// points alone (at walls, by other methods). A node of a face that is held has the half of its
/// surface before it. `half_width` (cells) is by body.
template <int Dim>
std::vector<SurfacePlace<Dim>> surface_places(const Grid<Dim>& grid, const Points& points,
                                              ShapeFunction shape,
                                              std::span<const double> half_width,
                                              const NodalAreas<Dim>& areas,
                                              const ContactFaces& held);

/// What a law has of one surface node.
template <int Dim>
struct SurfacePart {
  std::size_t row;  // of the areas
  double share;     // of the area, in [0, 1]
  Vec<Dim> vector;  // part of the area vector, m^(dim-1)
};

/// The area of some parts together, m^(dim-1); `area` is by row.
template <int Dim>
double area_of(std::span<const SurfacePart<Dim>> parts, std::span<const double> area) {
  double sum = 0.0;
  for (const SurfacePart<Dim>& part : parts) {
    sum += part.share * area[part.row];
  }
  return sum;
}

/// Divide the surface among regions: the first that covers a place has it, and null stands for all
/// that is left. A node at the edge of a region is shared in proportion: by a ramp as wide as a
/// cell looks from the edge, so that the shares of a flat surface add up to the area inside; a node
/// of a corner, whose area lies on several faces, face by face. A region whose own boundary runs
/// along the surface, at most a third of a cell below it, covers the surface: places are known to a
/// fraction of a cell. `places` is asked only where there are regions.
template <int Dim>
std::vector<std::vector<SurfacePart<Dim>>> divide_surface(
    const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
    const std::function<std::vector<SurfacePlace<Dim>>()>& places,
    std::span<const Shape* const> regions);

/// The places of areas that are known by the places of their nodes alone.
template <int Dim>
std::vector<SurfacePlace<Dim>> projected_places(const NodalAreas<Dim>& areas) {
  std::vector<SurfacePlace<Dim>> places;
  for (std::size_t k = 0; k < areas.node.size(); ++k) {
    places.push_back({areas.position[k], areas.normal[k], Mat<Dim>::Zero()});
  }
  return places;
}

}  // namespace lapilli
