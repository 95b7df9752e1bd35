#include "lapilli/mpm/surface/shape_areas.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapilli/mpm/surface/cut_shape.hpp"
#include "lapilli/mpm/surface/divide_pieces.hpp"

namespace lapilli {

template <int Dim>
std::vector<double> areas_of_shapes(const Grid<Dim>& grid, ShapeFunction function,
                                    std::span<const Shape> bodies,
                                    const std::vector<const Shape*>& regions,
                                    const ContactFaces& walls) {
  std::vector<double> areas(regions.size(), 0.0);
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    SurfaceDivision<Dim> division(grid, bodies, body, regions, walls);
    for (const CellCut<Dim>& cell : cut_shape<Dim>(bodies[body], grid, CubeLayout(function))) {
      for (const SurfacePiece<Dim>& piece : cell.pieces) {
        division.divide(piece, [&](int condition, const SurfacePiece<Dim>& part) {
          if (condition >= 0) {
            areas[static_cast<std::size_t>(condition)] += part.area();
          }
        });
      }
    }
  }
  return areas;
}

double AreaRatios::ratio_to(double wanted, std::span<const double> areas) {
  // Beyond this the nodes have found another surface than that of the shape; a part of it smaller
  // than a cell is found many times too large.
  constexpr double most = 3.0, least = 1e-3;
  const double ratio = wanted / std::accumulate(areas.begin(), areas.end(), 0.0);
  return ratio > least && ratio < most ? ratio : 1.0;
}

double AreaRatios::farthest() const {
  double farthest = 1.0;
  for (const double ratio : ratio_) {
    farthest = std::abs(ratio - 1.0) > std::abs(farthest - 1.0) ? ratio : farthest;
  }
  return farthest;
}

#define LAPILLI_INSTANTIATE(Dim)                                                                 \
  template std::vector<double> areas_of_shapes(                                                  \
      const Grid<Dim>&, ShapeFunction, std::span<const Shape>, const std::vector<const Shape*>&, \
      const ContactFaces&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
