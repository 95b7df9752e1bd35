#include "lapilli/scene/check.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>

#include "lapilli/core/memory.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/says_model.hpp"
#include "lapilli/core/seconds_since.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/scene/audit.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/body_volumes.hpp"
#include "lapilli/scene/build.hpp"
#include "lapilli/scene/check_large.hpp"
#include "lapilli/scene/check_model.hpp"
#include "lapilli/scene/check_stages.hpp"
#include "lapilli/scene/check_steps.hpp"
#include "lapilli/scene/few_cells.hpp"
#include "lapilli/scene/memory.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/run_scene.hpp"
#include "lapilli/scene/validate.hpp"

namespace lapilli {
namespace {

using Clock = std::chrono::steady_clock;

// What is looked at by building it; beyond, by its bounds.
constexpr double most_points = 2e6, most_memory = 2e9;  // bytes

void describe_grid(const Scene& scene, CheckReport& report) {
  report.dimension = dimension_of(scene);
  report.nodes = 1;
  for (std::size_t axis = 0; axis < scene.grid.lower.size(); ++axis) {
    const double length = scene.grid.upper[axis] - scene.grid.lower[axis];
    report.cells.push_back(std::lround(length / scene.grid.cell));
    report.nodes *= report.cells.back() + 1;
  }
}

void describe_bodies(const Scene& scene, const Simulation& simulation, CheckReport& report) {
  const Points& points = simulation.points();
  report.points = points.size();
  const std::vector<BodyVolume> volumes = body_volumes(scene, points);
  for (const BodyVolume& body : volumes) {
    report.bodies.push_back({body.name, 0, 0.0, 0.0, body.of_shape});
  }
  report.notes = volume_warnings(volumes, points.dimension());
  std::ranges::copy(packing_warnings(scene, points), std::back_inserter(report.notes));
  std::ranges::copy(few_cells(scene, points), std::back_inserter(report.notes));
  if (scene.peridynamics) {
    for (const FluidWallBody& wall : scene.peridynamics->walls) {
      report.bodies.push_back({message("wall ", wall.name), 0, 0.0, 0.0, {}});
    }
  }
  for (Index row = 0; row < points.size(); ++row) {
    CheckReport::BodyReport& body = report.bodies[static_cast<std::size_t>(points.body()[row])];
    ++body.points;
    body.volume += points.volume()[row];
  }
  for (CheckReport::BodyReport& body : report.bodies) {
    body.spacing = std::pow(body.volume / static_cast<double>(body.points), 1.0 / report.dimension);
  }
}

// What depends on how bodies lie is known once they are built.
void describe_choices(const Simulation& simulation, CheckReport& report) {
  for (const auto& physics : simulation.physics()) {
    if (const auto* chooser = dynamic_cast<const SaysModel*>(physics.get())) {
      std::ranges::copy(chooser->modelled(), std::back_inserter(report.modelled));
    }
    std::ranges::copy_if(warnings_of(*physics), std::back_inserter(report.notes),
                         [notes = report.notes](const Note& warning) {
                           return std::ranges::find(notes, warning) == notes.end();
                         });
  }
}

void describe_step(const Scene& scene, Simulation& simulation, CheckReport& report) {
  report.step = simulation.next_step_size();
  report.hard_limit = std::numeric_limits<double>::infinity();
  report.step_reason = scene.time.step || scene.time.steps ? "given" : "automatic";
  for (const auto& physics : simulation.physics()) {
    const StepLimit limit = physics->step_limit();
    if (limit.hard < report.hard_limit) {
      report.hard_limit = limit.hard;
      report.step_reason += "; " + limit.reason;
    }
  }
}

// What a run leaves on disk, before compression: the fields asked for at every frame.
double output_of(const Scene& scene, Simulation& simulation) {
  const FrameOptions frames = frame_options(scene);
  double bytes = 0.0;
  for (const Field& field : simulation.fields()) {
    if (is_asked_for(field, frames)) {
      const int numbers = field.components == 1 ? 1 : field.components <= 3 ? 3 : 9;
      bytes += numbers * (frames.single ? 4.0 : 8.0);
    }
  }
  const double end = simulation.end(), every = scene.output.every.value_or(end);
  const double count = 2.0 + static_cast<double>(scene.stages.size()) +
                       (every > 0.0 ? std::floor(end / every) : 0.0);
  return bytes * count * static_cast<double>(simulation.points().size());
}

/// A scene that would take long or much is described by its bounds alone.
CheckReport estimate(const Scene& scene, const SizeEstimate& size) {
  CheckReport report;
  report.title = scene.title;
  describe_grid(scene, report);
  describe_model(scene, report);
  report.points = static_cast<Index>(size.points);
  report.memory = size.memory;
  report.hard_limit = std::numeric_limits<double>::infinity();
  estimate_steps(scene, report);
  report.say("scene.not-built", "not built, since it is large: about ", size.points, " points and ",
             readable_bytes(size.memory), " by its bounds");
  return report;
}

}  // namespace

CheckReport check(const Scene& scene) {
  const Clock::time_point start = Clock::now();
  validate(with_resolved_files(scene));
  const SizeEstimate size = largest_size_of(with_resolved_files(scene));
  if (size.points > most_points || size.memory > most_memory) {
    require_feasible(with_resolved_files(scene));
    return estimate(scene, size);
  }
  const std::unique_ptr<Simulation> simulation = build(scene);
  CheckReport report;
  report.seconds_to_build = seconds_since(start);
  report.title = scene.title;
  describe_grid(scene, report);
  describe_bodies(scene, *simulation, report);
  describe_model(scene, report);
  std::ranges::copy(unused_settings(scene), std::back_inserter(report.notes));
  describe_step(scene, *simulation, report);
  report.memory =
      memory_of(scene, static_cast<double>(report.nodes), static_cast<double>(report.points));
  if (!size.stage.empty()) {
    report.memory = std::max(report.memory, size.memory);
  }
  report.output = output_of(scene, *simulation);
  describe_stages(scene, *simulation, report);
  measure_steps(scene, *simulation, report);
  describe_choices(*simulation, report);  // how often heat steps is known by now
  return report;
}

}  // namespace lapilli
