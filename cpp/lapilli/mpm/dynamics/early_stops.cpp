#include "lapilli/mpm/dynamics/early_stops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr double touching = 0.1, reach = 1.25;  // cells; beyond, no node of a face feels a point

/// Cells between a face and the nearest point of every body, less half of its width.
template <int Dim>
std::vector<double> gaps_to(const DynamicsData<Dim>& data, int axis, bool upper) {
  const auto& grid = data.grid;
  const double h = grid.cell_size();
  const double face = upper ? grid.upper()[axis] : grid.lower()[axis];
  std::vector<double> gaps(data.half_widths.size(), std::numeric_limits<double>::infinity());
  for (Index row = 0; row < data.points.size(); ++row) {
    const auto body = static_cast<std::size_t>(data.points.body()[row]);
    const double away = data.points.position()[row * Dim + axis] - face;
    gaps[body] = std::min(gaps[body], (upper ? -away : away) / h - data.half_widths[body]);
  }
  return gaps;
}

}  // namespace

template <int Dim>
std::vector<std::string> early_stops(const DynamicsData<Dim>& data,
                                     const std::vector<DynamicsBody>& bodies) {
  std::vector<std::string> all;
  const auto& gravity = data.settings.gravity;
  for (int axis = 0; axis < Dim; ++axis) {
    for (const bool upper : {false, true}) {
      if (data.walls[2 * axis + (upper ? 1 : 0)].is_open()) {
        continue;
      }
      const double pull = static_cast<std::size_t>(axis) < gravity.size() ? gravity[axis] : 0.0;
      const bool below = std::any_of(gravity.begin(), gravity.end(),
                                     [&](double other) { return std::abs(other) > std::abs(pull); })
                             ? false
                             : (upper ? pull > 0.0 : pull < 0.0);
      const std::vector<double> gaps = gaps_to(data, axis, upper);
      const std::string face = name_of(static_cast<GridFace>(2 * axis + (upper ? 1 : 0)));
      for (std::size_t body = 0; body < gaps.size(); ++body) {
        const double gap = gaps[body];
        if (!(gap > touching) || !std::isfinite(gap)) {
          continue;
        }
        if (gap < reach) {
          all.push_back(message(
              bodies[body].label, " starts about ", std::round(10.0 * gap) / 10.0,
              " cells from the grid boundary ", face,
              ", whose nodes hold it already: let it touch, or take an obstacle (half_space)"));
        } else if (below && gaps.size() == 1) {
          all.push_back(message(
              bodies[body].label, " falls onto the grid boundary ", face,
              ", whose nodes stop it up to a cell early; an obstacle (half_space) does not"));
        }
      }
    }
  }
  return all;
}

template std::vector<std::string> early_stops(const DynamicsData<2>&,
                                              const std::vector<DynamicsBody>&);
template std::vector<std::string> early_stops(const DynamicsData<3>&,
                                              const std::vector<DynamicsBody>&);

}  // namespace lapilli
