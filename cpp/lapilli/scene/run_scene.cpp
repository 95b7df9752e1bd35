#include "lapilli/scene/run_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "lapilli/output/checksum.hpp"
#include "lapilli/scene/audit.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/body_volumes.hpp"
#include "lapilli/scene/few_cells.hpp"
#include "lapilli/scene/identity.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "lapilli/scene/stage_scenes.hpp"
#include "lapilli/scene/validate_heat.hpp"

namespace lapilli {
namespace {

std::string text_for_record(const Scene& scene) {
  try {
    return to_toml(scene);
  } catch (const std::invalid_argument&) {
    return "";  // functions or arrays: the JSON settings name them
  }
}

/// A bound for the points of any stage; 0 where the first has as many as all.
Index most_points(const Scene& as_written, const Points& first) {
  if (as_written.stages.empty()) {
    return 0;
  }
  const std::vector<StageScene> stages = stage_scenes(with_resolved_files(as_written));
  std::vector<Index> of_body(body_names(as_written).size(), 0);
  for (const Index body : first.body()) {
    ++of_body[static_cast<std::size_t>(body)];
  }
  Index most = first.size();
  for (const StageScene& stage : stages) {
    Index here = 0;
    for (std::size_t body = 0; body < stage.scene.bodies.size(); ++body) {
      Index& count = of_body[static_cast<std::size_t>(stage.body_number[body])];
      if (stage.body_before[body] < 0 && count == 0) {
        count = static_cast<Index>(fill_body(stage.scene, body).size());
      }
      here += count;
    }
    most = std::max(most, here);
  }
  return most;
}

}  // namespace

Scene with_output(Scene scene, const std::string& path, double every) {
  if (!path.empty()) {
    scene.output.path = path;
  }
  if (every > 0.0) {
    scene.output.every = every;
    scene.output.every_steps.reset();
  }
  return scene;
}

FrameOptions frame_options(const Scene& scene) {
  FrameOptions options{scene.output.fields, scene.output.precision == Precision::single,
                       static_cast<int>(scene.output.compression), false};
  if (scene.dynamics && scene.dynamics->outside == Outside::remove) {
    options.points_leave = true;
  }
  if (!scene.stages.empty()) {
    options.points_leave = true;  // whether they do may change from stage to stage
  }
  return options;
}

std::vector<Probe> probes_of(const Scene& scene) {
  std::vector<Probe> probes;
  for (const ProbeSettings& probe : scene.probes) {
    probes.push_back({probe.name, place(probe.position), probe.field, probe.material_point});
  }
  return probes;
}

std::vector<std::filesystem::path> inputs_of(const Scene& as_written) {
  const Scene scene = with_resolved_files(as_written);
  const std::vector<std::string> own = input_files(scene);
  std::vector<std::filesystem::path> all(own.begin(), own.end());
  if (!scene.stages.empty()) {
    for (const StageScene& stage : stage_scenes(scene)) {
      const std::vector<std::string> of_stage = input_files(stage.scene);
      all.insert(all.end(), of_stage.begin(), of_stage.end());
    }
  }
  return all;
}

RunOptions run_options(const Scene& scene) {
  RunOptions options;
  if (!scene.output.path.empty()) {
    options.output = std::filesystem::absolute(scene.output.path);  // a run may change its folder
  }
  options.inputs = inputs_of(scene);
  options.frame_interval = scene.output.every.value_or(0.0);
  options.frame_steps = scene.output.every_steps.value_or(0);
  options.frames = frame_options(scene);
  options.probes = probes_of(scene);
  options.bodies = static_cast<int>(body_names(scene).size());
  if (scene.output.history_every) {
    options.history.emplace_back(*scene.output.history_every, 0);
  }
  for (const ProbeSettings& probe : scene.probes) {
    if (probe.every || probe.every_steps) {
      options.history.emplace_back(probe.every.value_or(0.0), probe.every_steps.value_or(0));
    }
  }
  options.notes = unused_settings(scene);
  std::ranges::copy(heat_warnings(scene), std::back_inserter(options.notes));
  options.checkpoint = scene.output.checkpoint;
  options.checkpoint_interval_seconds = scene.output.checkpoint_every.value_or(0.0);
  options.scene_text = text_for_record(scene);
  options.settings = to_json(scene);
  SceneIdentity identity = identity_of(scene);
  options.fingerprint = fingerprint(identity.lines);
  options.identity = std::move(identity.lines);
  options.not_compared = std::move(identity.not_compared);
  return options;
}

RunOptions run_options(const Scene& scene, const Points& points) {
  RunOptions options = run_options(scene);
  options.frames.most_points = most_points(scene, points);
  options.volumes = body_volumes_at_start(scene, points);
  std::ranges::copy(volume_warnings(options.volumes, points.dimension()),
                    std::back_inserter(options.notes));
  std::ranges::copy(packing_warnings(scene, points), std::back_inserter(options.notes));
  std::ranges::copy(few_cells(scene, points), std::back_inserter(options.notes));
  return options;
}

}  // namespace lapilli
