#include "lapilli/scene/check_large.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lapilli/core/require.hpp"
#include "lapilli/scene/check_steps.hpp"

namespace lapilli {
namespace {

/// The scene with cells `factor` times as large.
std::optional<CheckReport> check_coarser(Scene scene, double factor) {
  scene.stages.clear();
  scene.output = {};
  scene.grid.cell *= factor;
  for (std::size_t axis = 0; axis < scene.grid.lower.size(); ++axis) {
    const double length = scene.grid.upper[axis] - scene.grid.lower[axis];
    const double cells = std::ceil(length / scene.grid.cell * (1.0 - 1e-9));
    scene.grid.upper[axis] = scene.grid.lower[axis] + cells * scene.grid.cell;
  }
  try {
    return check(scene);
  } catch (const std::exception&) {  // it holds fewer cells than some part of it needs
    return std::nullopt;
  }
}

double seconds_of_a_step(const CheckReport& report) {
  return report.seconds_to_run / static_cast<double>(std::max<Index>(report.steps, 1));
}

}  // namespace

void estimate_steps(const Scene& scene, CheckReport& report) {
  constexpr double few = 1e4, few_nodes = 1e6;  // of the coarser copy, at most
  constexpr double ratio = 1.4;                 // of their cells
  const auto points = static_cast<double>(report.points);
  const double parts = std::max(points / few, static_cast<double>(report.nodes) / few_nodes);
  const double factor = std::pow(parts, 1.0 / report.dimension);
  const bool has_copies = scene.initial_state.empty() && std::isfinite(factor) && factor > ratio;
  const auto coarse = has_copies ? check_coarser(scene, factor) : std::nullopt;
  const auto finer = coarse ? check_coarser(scene, factor / ratio) : std::nullopt;
  if (!finer || !(coarse->step > 0.0) || !(finer->step > 0.0)) {
    report.step_reason = "not known: not built, and no copy of the scene with larger cells can be";
    return;
  }
  const double power = std::log(coarse->step / finer->step) / std::log(ratio);
  const double shrinks = std::pow(ratio / factor, std::clamp(power, 0.0, 2.0));
  const double more = points / static_cast<double>(std::max<Index>(finer->points, 1));
  report.step = finer->step * shrinks;
  report.hard_limit = finer->hard_limit * shrinks;
  report.step_reason =
      message("about, from copies with cells ", std::round(10.0 * factor / ratio) / 10.0, " and ",
              std::round(10.0 * factor) / 10.0, " times as large");
  report.steps = whole_steps(steps_until_end(scene, 0.0, report.step));
  report.seconds_to_run = seconds_of_a_step(*finer) * more * static_cast<double>(report.steps);
  report.seconds_to_build = finer->seconds_to_build * more;
}

}  // namespace lapilli
