#include "lapilli/mpm/surface/nodal_surface.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {

template <int Dim>
NodalSums<Dim> nodal_sums(const Points& points, const Grid<Dim>& grid, ShapeFunction function,
                          std::span<const double> half_width) {
  NodalSums<Dim> sums;
  sums.fraction.assign(static_cast<std::size_t>(grid.node_count()), 0.0);
  sums.area_vector.assign(sums.fraction.size(), Vec<Dim>::Zero());
  const double per_cell = 1.0 / grid.cell_volume();
  for (Index row = 0; row < points.size(); ++row) {
    const double volume = points.volume()[row];
    with_shape(function, half_width[points.body()[row]], [&](auto shape) {
      const Weights<Dim, decltype(shape)> weights(grid, shape,
                                                  points.position().data() + row * Dim);
      weights.for_each_node(grid, [&](Index node, double s, const Vec<Dim>& slope) {
        sums.fraction[node] += per_cell * volume * s;
        sums.area_vector[node] += volume * slope;
      });
    });
  }
  return sums;
}

#define LAPILLI_INSTANTIATE(Dim)                                                     \
  template NodalSums<Dim> nodal_sums(const Points&, const Grid<Dim>&, ShapeFunction, \
                                     std::span<const double>);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
