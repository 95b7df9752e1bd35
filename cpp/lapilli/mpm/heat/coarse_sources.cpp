#include "lapilli/mpm/heat/coarse_sources.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/in_brackets.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"

namespace lapilli {
namespace {

constexpr double least_told = 0.03;  // of the rise, and .01 of the span
constexpr double evened_out = 0.05;  // thickness^2 / diffusivity, from which it is a parabola

/// The surface through which a body may give its heat away, m^(dim-1), and what resists it there,
/// m^2 K/W.
struct WayOut {
  double area = 0.0, resistance = 0.0;
};

WayOut way_out(const SurfaceFound& body, const HeatSettings& settings) {
  WayOut out;
  double exchange = 0.0;
  bool holds = false;
  for (std::size_t law = 0; law < body.ends.size(); ++law) {
    const HeatBoundary& condition = settings.boundaries[law];
    if (surroundings_of(condition) == nullptr) {
      continue;
    }
    out.area += body.ends[law].area;
    holds = holds || (holds_temperature(condition) && body.ends[law].area > 0.0);
    exchange += body.ends[law].area * largest_coefficient(condition, 0.0, absolute_zero(settings));
  }
  out.resistance = holds || !(exchange > 0.0) ? 0.0 : out.area / exchange;
  return out;
}

}  // namespace

template <int Dim>
std::vector<Note> coarse_sources(std::span<const SurfaceFound> found,
                                 const HeatProblem<Dim>& problem, double span, double time) {
  std::vector<Note> all;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const HeatBody& body = problem.bodies[k];
    const bool touches =
        std::ranges::any_of(found[k].near, [](const auto& other) { return other.touches; });
    const WayOut out = way_out(found[k], problem.settings);
    if (body.source.is_function() || body.source.at(time) == 0.0 || touches || !(out.area > 0.0)) {
      continue;
    }
    // Found on plates, disks and balls of 2 to 6 cells, anywhere on the grid.
    const double thickness = 2.0 * found[k].volume / out.area;
    const double cells = thickness / problem.grid.cell_size();
    const double conductivity = largest_conductivity(body.material);
    const double depth = depth_of_heat(body.material, time);
    const bool risen = depth * depth > evened_out * thickness * thickness;
    const double within = thickness * thickness / (8.0 * conductivity);
    const double rise = within + 0.5 * thickness * out.resistance;  // times the source
    const double off = std::min(0.5, 0.2 / (cells * cells)) * within / rise;
    if (risen && off > least_told && off * rise * std::abs(body.source.at(time)) > 0.01 * span) {
      all.push_back(
          note("heat.few-cells", "bodies.", k, in_brackets(body.name),
               " is heated from within and ", std::round(10.0 * cells) / 10.0,
               " cells thick (twice its volume over its surface): its rise of temperature "
               "may be ",
               std::lround(100.0 * off), " % too small; halve grid.cell to quarter that"));
    }
  }
  return all;
}

#define LAPILLI_INSTANTIATE(Dim)                                           \
  template std::vector<Note> coarse_sources(std::span<const SurfaceFound>, \
                                            const HeatProblem<Dim>&, double, double);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
