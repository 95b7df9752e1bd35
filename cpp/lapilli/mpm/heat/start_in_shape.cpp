#include "lapilli/mpm/heat/start_in_shape.hpp"

#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

template <int Dim>
Vec3 place_of(const Grid<Dim>& grid, Index node) {
  Vec3 at = Vec3::Zero();
  at.template head<Dim>() = grid.node_position(node);
  return at;
}

/// The smaller of two changes where they agree in sign.
double agreed(double one, double other) {
  return one * other <= 0.0 ? 0.0 : std::abs(one) < std::abs(other) ? one : other;
}

}  // namespace

template <int Dim>
std::vector<Vec3> places_in_shape(const Shape& shape, const Grid<Dim>& grid,
                                  std::span<const Index> nodes) {
  std::vector<Vec3> places;
  for (const Index node : nodes) {
    const Vec3 at = place_of(grid, node);
    places.push_back(distance(shape, at) <= 0.0 ? at : project(shape, at));
  }
  return places;
}

template <int Dim>
std::vector<double> start_at_nodes(const Value& temperature, const Shape& shape,
                                   const Grid<Dim>& grid, std::span<const Index> nodes,
                                   std::size_t body) {
  std::vector<double> values(nodes.size());
  if (!temperature.is_function()) {
    std::fill(values.begin(), values.end(), temperature.at(0.0));
  } else {
    // Beside every node its mirror images, one and two times as far inside the surface.
    const std::vector<Vec3> place = places_in_shape<Dim>(shape, grid, nodes);
    std::vector<Vec3> all = place;
    std::vector<std::size_t> mirror(nodes.size(), 0);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Vec3 inward = place[k] - place_of(grid, nodes[k]);
      if (!inward.isZero(0.0) && distance(shape, place[k] + inward) <= 0.0 &&
          distance(shape, place[k] + 2.0 * inward) <= 0.0) {
        mirror[k] = all.size();
        all.push_back(place[k] + inward);
        all.push_back(place[k] + 2.0 * inward);
      }
    }
    std::vector<double> known(all.size());
    temperature.evaluate(all, {}, 0.0, known);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      values[k] = known[k];
      if (const std::size_t m = mirror[k]; m > 0) {
        values[k] += agreed(known[k] - known[m], known[m] - known[m + 1]);
      }
    }
  }
  for (const double value : values) {
    require(std::isfinite(value), "initial temperature of body ", body, " is not finite");
  }
  return values;
}

#define LAPILLI_INSTANTIATE(Dim)                                                            \
  template std::vector<Vec3> places_in_shape(const Shape&, const Grid<Dim>&,                \
                                             std::span<const Index>);                       \
  template std::vector<double> start_at_nodes(const Value&, const Shape&, const Grid<Dim>&, \
                                              std::span<const Index>, std::size_t);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
