#include "lapilli/mpm/heat/temperature_range.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

bool is_zero(const Value& value) { return value.is_constant() && value.at(0.0) == 0.0; }

}  // namespace

double absolute_zero(const HeatSettings& settings) {
  return settings.unit == TemperatureUnit::celsius ? -273.15 : 0.0;
}

template <int Dim>
TemperatureRange diverged_beyond(const HeatProblem<Dim>& problem, std::span<const double> start) {
  const auto [least, most] = std::minmax_element(start.begin(), start.end());
  double low = *least, high = *most;
  for (const HeatBoundary& law : problem.settings.boundaries) {
    const Value* outside = surroundings_of(law);
    if (outside == nullptr || outside->is_function()) {
      return {};
    }
    low = std::min(low, outside->least());
    high = std::max(high, outside->largest());
  }
  for (const HeatObstacle& obstacle : problem.obstacles) {
    if (obstacle.temperature) {
      low = std::min(low, obstacle.temperature->least());
      high = std::max(high, obstacle.temperature->largest());
    }
  }
  for (const HeatBody& body : problem.bodies) {
    if (!is_zero(body.source)) {
      return {};
    }
  }
  const double span = std::max(high - low, 1e-6 * std::max(std::abs(low), std::abs(high)));
  return {low - 3.0 * span, high + 3.0 * span};
}

template <int Dim>
void require_absolute(const HeatProblem<Dim>& problem, const Points& points,
                      std::span<const double> start) {
  const bool absolute = any_needs_absolute(problem.settings.boundaries);
  const double zero = absolute_zero(problem.settings);
  for (Index row = 0; absolute && row < points.size(); ++row) {
    require(start[static_cast<std::size_t>(row)] >= zero, "initial temperature of point ",
            points.id()[row], " of body ", points.body()[row], " is ",
            start[static_cast<std::size_t>(row)], ", below absolute zero at ", zero,
            ": temperatures under radiation are absolute (temperature_unit says their unit)");
  }
}

template <int Dim>
void require_finite_nodes(const Grid<Dim>& grid, const NodeRows<Dim>& rows,
                          std::span<const double> temperature) {
  for (const auto& row : rows.rows()) {
    for (int i = row.begin; i < row.end; ++i) {
      if (!std::isfinite(temperature[row.shift + i])) {
        const Index node = row.grid_row * grid.nodes(0) + i;
        throw RunError(message(
            "heat: temperature of the node at (", grid.node_position(node).transpose(),
            ") is not finite; a boundary condition or source gave such a value, or the step is "
            "too large for it"));
      }
    }
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                                   \
  template TemperatureRange diverged_beyond(const HeatProblem<Dim>&, std::span<const double>);     \
  template void require_absolute(const HeatProblem<Dim>&, const Points&, std::span<const double>); \
  template void require_finite_nodes(const Grid<Dim>&, const NodeRows<Dim>&,                       \
                                     std::span<const double>);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
