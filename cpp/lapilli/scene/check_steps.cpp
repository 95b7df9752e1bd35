#include "lapilli/scene/check_steps.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/seconds_since.hpp"
#include "lapilli/mpm/heat/steps_ahead.hpp"

namespace lapilli {
namespace {

using Clock = std::chrono::steady_clock;

// Steps of later stages count by their points.
double steps_of_later_stages(const CheckReport& report) {
  double steps = 0.0;
  for (const CheckReport::StageReport& stage : report.stages) {
    steps += static_cast<double>(stage.steps) * static_cast<double>(stage.points) /
             static_cast<double>(report.points);
  }
  return steps;
}

/// What heat has ahead whose steps grow or are chosen.
StepsAhead chosen_steps(const Simulation& simulation) {
  for (const auto& physics : simulation.physics()) {
    if (const auto* teller = dynamic_cast<const TellsStepsAhead*>(physics.get())) {
      return teller->steps_ahead();
    }
  }
  return {};
}

}  // namespace

double steps_until_end(const Scene& scene, double begin, double size) {
  const double end = scene.time.end, every = scene.output.every.value_or(end);
  double steps = 0.0;
  const auto add_steps = [&](double span, double times) {
    steps += times * std::ceil(std::max(0.0, span) / size * (1.0 - 1e-9));
  };
  const double next_frame = std::min(end, every * (std::floor(begin / every * (1.0 + 1e-9)) + 1.0));
  add_steps(next_frame - begin, 1.0);
  const double frames = std::floor((end - next_frame) / every * (1.0 + 1e-9));
  add_steps(every, frames);
  add_steps(end - next_frame - frames * every, 1.0);
  return steps;
}

Index whole_steps(double steps) { return static_cast<Index>(std::min(steps, 9e18)); }

// The first step also assembles what later ones use, and is often shorter, so it is not counted.
void measure_steps(const Scene& scene, Simulation& simulation, CheckReport& report) {
  constexpr double patience = 0.3;  // s
  const Clock::time_point first = Clock::now();
  double seconds_of_first = 0.0, seconds_of_others = 0.0, weight = 0.0;
  Index taken = 0;
  double size = report.step;
  try {
    simulation.step(scene.time.end);
    seconds_of_first = seconds_since(first);
    const Clock::time_point start = Clock::now();
    while (simulation.time() < scene.time.end && seconds_of_others < patience) {
      size = simulation.next_step_size();
      weight += chosen_steps(simulation).next;
      simulation.step(scene.time.end);
      ++taken;
      seconds_of_others = seconds_since(start);
    }
  } catch (const RunError& error) {
    report.notes.push_back(note("run.fails-soon", "fails soon: ", error.what()));
  }
  double left = 0.0, left_cost = 0.0;  // in steps like those taken
  const StepsAhead chosen = chosen_steps(simulation);
  const bool is_given = scene.time.step || scene.time.steps;
  if (simulation.time() < scene.time.end) {
    size = is_given || chosen.number > 0.0 ? size : std::max(size, chosen.settled);
    left = left_cost = steps_until_end(scene, simulation.time(), size);
    if (chosen.number > 0.0) {
      const double frames = steps_until_end(scene, simulation.time(), scene.time.end);
      left = std::max(chosen.number, frames);
      left_cost = chosen.cost * left / chosen.number;
    }
  }
  // Beside their limit: explicit ones, whatever longer ones follow.
  report.step = is_given || chosen.settled <= 0.0 ? size : chosen.settled;
  report.steps = 1 + taken + whole_steps(left);
  const double cost = taken == 0 ? seconds_of_first : seconds_of_others / weight;
  report.seconds_to_run = cost * (1.0 + weight + left_cost + steps_of_later_stages(report));
}

}  // namespace lapilli
