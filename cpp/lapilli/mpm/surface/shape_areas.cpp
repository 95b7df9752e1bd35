#include "lapilli/mpm/surface/shape_areas.hpp"

#include <algorithm>
#include <numeric>

#include "lapilli/mpm/surface/cut_shape.hpp"
#include "lapilli/mpm/surface/divide_pieces.hpp"

namespace lapilli {

template <int Dim>
ShapeAreas areas_of_shapes(const Grid<Dim>& grid, ShapeFunction function,
                           std::span<const Shape> bodies, const std::vector<const Shape*>& regions,
                           const ContactFaces& walls) {
  ShapeAreas areas;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    double whole = 0.0;
    std::vector<double> by_condition(regions.size(), 0.0);
    SurfaceDivision<Dim> division(grid, bodies, body, regions, walls);
    for (const CellCut<Dim>& cell : cut_shape<Dim>(bodies[body], grid, CubeLayout(function))) {
      for (const SurfacePiece<Dim>& piece : cell.pieces) {
        division.divide(piece, [&](int condition, const SurfacePiece<Dim>& part) {
          if (condition >= 0) {
            by_condition[static_cast<std::size_t>(condition)] += part.area();
          }
          whole += condition >= SurfaceDivision<Dim>::nobody ? part.area() : 0.0;
        });
      }
    }
    areas.whole.push_back(whole);
    areas.by_condition.push_back(std::move(by_condition));
    areas.touching.push_back(division.touching());
  }
  return areas;
}

std::vector<std::vector<std::size_t>> groups_of(
    const std::vector<std::vector<std::size_t>>& touching) {
  std::vector<std::size_t> group(touching.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (std::size_t round = 0; round < touching.size(); ++round) {
    for (std::size_t body = 0; body < touching.size(); ++body) {
      for (const std::size_t other : touching[body]) {
        group[body] = group[other] = std::min(group[body], group[other]);
      }
    }
  }
  std::vector<std::vector<std::size_t>> groups(touching.size());
  for (std::size_t body = 0; body < touching.size(); ++body) {
    groups[group[body]].push_back(body);
  }
  std::erase_if(groups, [](const auto& some) { return some.empty(); });
  return groups;
}

#define LAPILLI_INSTANTIATE(Dim)                                                               \
  template ShapeAreas areas_of_shapes(const Grid<Dim>&, ShapeFunction, std::span<const Shape>, \
                                      const std::vector<const Shape*>&, const ContactFaces&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
