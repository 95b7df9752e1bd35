#include "lapilli/mpm/heat/thin_columns.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {
namespace {

constexpr double look_at = 3.0;                // cells below the surface
constexpr double is_thin = 0.05, ends = 0.25;  // of a full node, there

}  // namespace

template <int Dim>
std::vector<double> thin_columns(const Grid<Dim>& grid, const Points& points,
                                 const std::vector<SurfaceFoot<Dim>>& feet,
                                 const HeatCoefficients<Dim>& coefficients,
                                 const std::vector<double>& capacity) {
  const double cell = grid.cell_size();
  std::vector<double> all;
  for (const SurfaceFoot<Dim>& foot : feet) {
    const Vec<Dim> at = foot.place + look_at * cell * foot.normal;
    double found = 0.0;
    if (grid.contains(at)) {
      with_shape(ShapeFunction::linear, 0.5, [&](auto shape) {
        Weights<Dim, decltype(shape)>(grid, shape, at.data())
            .for_each_node(grid, [&](Index node, double weight, const Vec<Dim>&) {
              found += weight * capacity[node];
            });
      });
    }
    const auto body = static_cast<std::size_t>(points.body()[foot.row]);
    const double full = coefficients.capacity[body] * std::pow(cell, Dim);
    all.push_back(std::clamp((ends - found / full) / (ends - is_thin), 0.0, 1.0));
  }
  return all;
}

#define LAPILLI_INSTANTIATE(Dim)                                             \
  template std::vector<double> thin_columns(                                 \
      const Grid<Dim>&, const Points&, const std::vector<SurfaceFoot<Dim>>&, \
      const HeatCoefficients<Dim>&, const std::vector<double>&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
