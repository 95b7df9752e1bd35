#include "lapilli/scene/run_scene.hpp"

#include <algorithm>
#include <iterator>

#include "lapilli/output/checksum.hpp"
#include "lapilli/scene/audit.hpp"
#include "lapilli/scene/body_volumes.hpp"
#include "lapilli/scene/identity.hpp"
#include "lapilli/scene/scene_file.hpp"
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
  return {scene.output.fields, scene.output.precision == Precision::single,
          static_cast<int>(scene.output.compression),
          scene.dynamics && scene.dynamics->outside == Outside::remove};
}

std::vector<Probe> probes_of(const Scene& scene) {
  std::vector<Probe> probes;
  for (const ProbeSettings& probe : scene.probes) {
    probes.push_back({probe.name, place(probe.position), probe.field, probe.material_point});
  }
  return probes;
}

RunOptions run_options(const Scene& scene) {
  RunOptions options;
  options.output = scene.output.path;
  options.frame_interval = scene.output.every.value_or(0.0);
  options.frame_steps = scene.output.every_steps.value_or(0);
  options.frames = frame_options(scene);
  options.probes = probes_of(scene);
  options.bodies = static_cast<int>(scene.bodies.size());
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
  options.volumes = body_volumes_at_start(scene, points);
  std::ranges::copy(volume_warnings(options.volumes, points.dimension()),
                    std::back_inserter(options.notes));
  return options;
}

}  // namespace lapilli
