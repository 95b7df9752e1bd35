#include "lapilli/scene/build.hpp"

#include "lapilli/core/memory.hpp"
#include "lapilli/output/owned_files.hpp"
#include "lapilli/output/run_files.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/build_parts.hpp"
#include "lapilli/scene/memory.hpp"
#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/run_scene.hpp"
#include "lapilli/scene/stage_scenes.hpp"
#include "lapilli/scene/validate.hpp"

namespace lapilli {
namespace {

using Parts = Simulation::Stage::Parts;

Simulation::Clock clock_of(const Scene& scene, double start = 0.0) {
  Simulation::Clock clock;
  clock.start = start;
  clock.end = scene.time.end;
  if (scene.time.steps) {
    clock.fixed_step = (scene.time.end - start) / static_cast<double>(*scene.time.steps);
  } else if (scene.time.step) {
    clock.fixed_step = *scene.time.step;
  }
  return clock;
}

// Which fields there are, and where material is, is known now.
void check_probes(const Scene& scene, Simulation& simulation) {
  const std::vector<Probe> probes = probes_of(scene);
  Mistakes mistakes;
  for (std::size_t k = 0; k < probes.size(); ++k) {
    mistakes.gather([&] {
      in_file(scene, element_path("probes", k), [&] {
        const Probes one(simulation, {probes[k]}, static_cast<int>(scene.bodies.size()));
        one.read(simulation, true);
      });
    });
  }
  mistakes.throw_if_any();
}

// Known now, not when the run would begin to write.
void check_output(const Scene& scene) {
  if (!scene.output.path.empty()) {
    in_file(scene, "output.path",
            [&] { require_apart(files_of_run(scene.output.path), inputs_of(scene)); });
  }
}

void check_fields(const Scene& scene, Simulation& simulation) {
  if (scene.output.fields) {
    in_file(scene, "output.fields",
            [&] { require_fields(simulation.fields(), frame_options(scene)); });
  }
}

using Stages = std::vector<StageScene>;

/// Solids of all bodies in the stages other than `own`, for what points keep of them.
std::vector<Solid> solids_of_others(const Stages& stages, std::size_t own) {
  std::vector<Solid> solids;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    for (const Body& body : stages[k].scene.bodies) {
      if (k != own) {
        const std::vector<Solid> some = solids_in(body);
        solids.insert(solids.end(), some.begin(), some.end());
      }
    }
  }
  return solids;
}

/// How the points of a stage start; null where all do so anew and there is no other stage.
std::shared_ptr<const PointStart> start_of(const Stages& stages, std::size_t k,
                                           const Beginning& beginning) {
  if (!beginning.initial && stages.size() == 1) {
    return nullptr;
  }
  auto start = std::make_shared<PointStart>();
  if (beginning.initial) {
    *start = beginning.initial->start(beginning.filled);
  } else {
    start->body.assign(stages[k].scene.bodies.size(), -1);
  }
  start->time = beginning.time;
  start->other_stages = solids_of_others(stages, k);
  return start;
}

/// The scene before the first step.
Beginning first_beginning(const Stages& stages) {
  const Scene& scene = stages.front().scene;
  Beginning beginning;
  beginning.filled = fill_bodies(scene);
  if (!scene.initial_state.empty()) {
    beginning.initial.emplace(scene);
    beginning.initial->replace(beginning.filled);
  }
  beginning.start = start_of(stages, 0, beginning);
  return beginning;
}

/// A body as it was filled in the stage that it is from.
FilledPoints filled_as_new(const Stages& stages, std::size_t stage, std::size_t body) {
  while (stages[stage].body_before[body] >= 0) {
    body = static_cast<std::size_t>(stages[stage].body_before[body]);
    --stage;
  }
  return fill_body(stages[stage].scene, body);
}

Parts begin_stage(const Stages& stages, std::size_t k,
                  const std::shared_ptr<const Archive>& before) {
  const StageScene& stage = stages[k];
  Beginning beginning;
  beginning.initial.emplace(stage, before);
  std::vector<bool> goes_on;
  for (std::size_t body = 0; body < stage.scene.bodies.size(); ++body) {
    beginning.filled.push_back(filled_as_new(stages, k, body));
    goes_on.push_back(beginning.goes_on(body));
  }
  beginning.initial->replace(beginning.filled);
  require_apart(stage.scene, beginning.filled, goes_on);
  beginning.time = stage.start;
  beginning.start = start_of(stages, k, beginning);
  return with_memory_for("begin a stage", [&] {
    Parts parts = parts_of(stage.scene, beginning);
    parts.body_numbers = stage.body_number;
    return parts;
  });
}

/// Bodies that a stage adds can be filled: known now, not after hours.
void check_added(const Stages& stages) {
  for (std::size_t k = 1; k < stages.size(); ++k) {
    for (std::size_t body = 0; body < stages[k].body_before.size(); ++body) {
      if (stages[k].body_before[body] < 0) {
        try {
          fill_body(stages[k].scene, body);
        } catch (const std::invalid_argument& error) {
          throw std::invalid_argument(
              message("stages[", k - 1, "] '", stages[k].name, "': ", error.what()));
        }
      }
    }
  }
}

std::vector<Simulation::Stage> later_stages(const std::shared_ptr<const Stages>& stages) {
  std::vector<Simulation::Stage> all;
  for (std::size_t k = 1; k < stages->size(); ++k) {
    const StageScene& stage = (*stages)[k];
    all.push_back({stage.name, clock_of(stage.scene, stage.start),
                   [stages, k](const std::shared_ptr<const Archive>& before) {
                     return begin_stage(*stages, k, before);
                   }});
  }
  return all;
}

std::unique_ptr<Simulation> first_stage(const Stages& stages) {
  const Scene& scene = stages.front().scene;
  Parts parts = parts_of(scene, first_beginning(stages));
  auto simulation = in_file(scene, scene.time.steps ? "time.steps" : "time.step", [&] {
    return std::make_unique<Simulation>(std::move(parts.points), std::move(parts.physics),
                                        clock_of(scene));
  });
  check_probes(scene, *simulation);
  check_fields(scene, *simulation);
  return simulation;
}

}  // namespace

std::unique_ptr<Simulation> build(const Scene& as_written) {
  Scene scene = with_resolved_files(as_written);
  validate(scene);
  check_output(scene);
  require_feasible(scene);
  const auto stages = std::make_shared<const Stages>(stage_scenes(std::move(scene)));
  return with_memory_for("build the scene", [&] {
    std::unique_ptr<Simulation> simulation = first_stage(*stages);
    if (stages->size() > 1) {
      check_added(*stages);
      simulation->follow_with(later_stages(stages));
    }
    return simulation;
  });
}

}  // namespace lapilli
