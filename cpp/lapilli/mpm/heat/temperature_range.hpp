#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "lapilli/algebra/node_rows.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"

namespace lapilli {

/// Absolute zero in the unit of a scene's temperatures.
double absolute_zero(const HeatSettings& settings);

/// The temperatures that a scene can reach by conduction and exchange alone: from the least to the
/// largest of its start and of what surrounds it. A run that leaves them by three times their span
/// has diverged. Without end where fluxes, sources, other physics or functions of time heat.
struct TemperatureRange {
  double low = -std::numeric_limits<double>::infinity();  // K
  double high = std::numeric_limits<double>::infinity();  // K

  bool holds(double temperature) const { return temperature >= low && temperature <= high; }
};

/// The range beyond which a run has diverged, from the temperatures at the start.
template <int Dim>
TemperatureRange diverged_beyond(const HeatProblem<Dim>& problem, std::span<const double> start);

/// The range that start and surroundings span, from the one beyond which a run has diverged.
inline TemperatureRange reached(const TemperatureRange& beyond) {
  const double span = (beyond.high - beyond.low) / 7.0;
  return std::isfinite(span) ? TemperatureRange{beyond.low + 3.0 * span, beyond.high - 3.0 * span}
                             : beyond;
}

/// Throws std::invalid_argument for a temperature at the start below absolute zero where surfaces
/// radiate.
template <int Dim>
void require_absolute(const HeatProblem<Dim>& problem, const Points& points,
                      std::span<const double> start);

/// Throws RunError naming the first node whose temperature, stored by place, is not finite.
template <int Dim>
void require_finite_nodes(const Grid<Dim>& grid, const NodeRows<Dim>& rows,
                          std::span<const double> temperature);

}  // namespace lapilli
