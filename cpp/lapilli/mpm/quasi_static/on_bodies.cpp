#include "lapilli/mpm/quasi_static/on_bodies.hpp"

#include <algorithm>
#include <limits>

#include "lapilli/core/in_space.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr double off = 0.02;    // cells, from where a surface does not lie on a body
constexpr double most = 0.5;    // share of a surface
constexpr double probe = 0.05;  // cells

}  // namespace

double distance_to(const std::vector<Shape>& bodies, const Vec3& at) {
  double least = std::numeric_limits<double>::infinity();
  for (const Shape& body : bodies) {
    least = std::min(least, lapilli::distance(body, at));
  }
  return least;
}

template <int Dim>
void require_pushes(const std::vector<Shape>& bodies, const std::vector<Facet<Dim>>& facets,
                    double cell_size, const SurfaceSettings& surface, const std::string& what) {
  double area = 0.0, pulls = 0.0;
  for (const Facet<Dim>& facet : facets) {
    for (const SurfacePoint<Dim>& point : facet.points) {
      const Vec<Dim> step = probe * cell_size * point.normal;
      const bool before = distance_to(bodies, in_space<Dim>(point.position - step)) < 0.0;
      const bool behind = distance_to(bodies, in_space<Dim>(point.position + step)) < 0.0;
      area += point.weight;
      pulls += before && !behind ? point.weight : 0.0;
    }
  }
  if (pulls > most * area) {
    throw RunError(message(what,
                           " has a pressure that comes from within the body and pulls at it: ",
                           !surface.shape   ? "turn its line, which has the material on its left"
                           : surface.inside ? "leave out inside = true"
                                            : "set inside = true"));
  }
}

template <int Dim>
void reach_from_bodies(const Grid<Dim>& grid, const CellState<Dim>& state,
                       const std::vector<Shape>& bodies, std::vector<Facet<Dim>>& facets) {
  if (bodies.empty()) {
    return;
  }
  for (Facet<Dim>& facet : facets) {
    if (state.occupied[grid.cell_index(facet.cell)] ||
        distance_to(bodies, in_space<Dim>(facet.centre())) <= off * grid.cell_size()) {
      continue;
    }
    const Index inner = inner_cell(grid, facet);
    if (inner >= 0 && inner < grid.cell_count() && state.occupied[inner]) {
      facet.cell = grid.cell_at(inner);
    }
  }
}

template <int Dim>
double distance_off(const std::vector<Shape>& bodies, const std::vector<Facet<Dim>>& facets,
                    int wall, double cell_size) {
  double area = 0.0, away = 0.0, farthest = 0.0;
  for (const Facet<Dim>& facet : facets) {
    for (const SurfacePoint<Dim>& point : facet.points) {
      if (facet.surface != wall) {
        continue;
      }
      const double distance = distance_to(bodies, in_space<Dim>(point.position));
      area += point.weight;
      away += distance > off * cell_size ? point.weight : 0.0;
      farthest = std::max(farthest, distance);
    }
  }
  return away > most * area ? farthest : 0.0;
}

#define LAPILLI_INSTANTIATE(Dim)                                                               \
  template void require_pushes<Dim>(const std::vector<Shape>&, const std::vector<Facet<Dim>>&, \
                                    double, const SurfaceSettings&, const std::string&);       \
  template void reach_from_bodies<Dim>(const Grid<Dim>&, const CellState<Dim>&,                \
                                       const std::vector<Shape>&, std::vector<Facet<Dim>>&);   \
  template double distance_off<Dim>(const std::vector<Shape>&, const std::vector<Facet<Dim>>&, \
                                    int, double);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
