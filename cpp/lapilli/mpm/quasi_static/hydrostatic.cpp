#include "lapilli/mpm/quasi_static/hydrostatic.hpp"

#include <cmath>

#include "lapilli/mpm/surface/cut_shape.hpp"

namespace lapilli {

template <int Dim>
std::optional<LoadedSurface<Dim>> skin_of(const Grid<Dim>& grid, const std::vector<Shape>& shapes,
                                          std::span<const char> averaged,
                                          std::span<const double> volume) {
  constexpr double largest_gap = 1e-3;  // of the volume, and of the area that does not close
  if (shapes.size() != averaged.size()) {
    return std::nullopt;
  }
  std::vector<Facet<Dim>> facets;
  for (std::size_t body = 0; body < shapes.size(); ++body) {
    if (!averaged[body]) {
      continue;
    }
    double bounded = 0.0, area = 0.0;
    Vec<Dim> open = Vec<Dim>::Zero();
    const Vec<Dim> middle = 0.5 * (grid.lower() + grid.upper());
    for (const CellCut<Dim>& cut :
         cut_shape<Dim>(shapes[body], grid, CubeLayout(ShapeFunction::linear))) {
      for (const SurfacePiece<Dim>& piece : cut.pieces) {
        Facet<Dim> facet{0, cut.node, {}};
        for (const QuadraturePoint<Dim>& point : piece.quadrature()) {
          facet.points.push_back({point.position, Vec<Dim>(-piece.normal), point.weight});
          bounded += point.weight * piece.normal.dot(point.position - middle) / Dim;
        }
        open += piece.area() * piece.normal;
        area += piece.area();
        facets.push_back(std::move(facet));
      }
    }
    if (std::abs(bounded - volume[body]) > largest_gap * volume[body] ||
        open.norm() > largest_gap * area) {
      return std::nullopt;
    }
  }
  LoadedSurface<Dim> skin("the surface of the bodies");
  skin.start(facets);
  return skin;
}

template std::optional<LoadedSurface<2>> skin_of(const Grid<2>&, const std::vector<Shape>&,
                                                 std::span<const char>, std::span<const double>);
template std::optional<LoadedSurface<3>> skin_of(const Grid<3>&, const std::vector<Shape>&,
                                                 std::span<const char>, std::span<const double>);

}  // namespace lapilli
