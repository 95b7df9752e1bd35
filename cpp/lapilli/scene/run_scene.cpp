#include "lapilli/scene/run_scene.hpp"

#include "lapilli/output/checksum.hpp"
#include "lapilli/scene/scene_file.hpp"

namespace lapilli {
namespace {

std::string text_for_record(const Scene& scene) {
  try {
    return to_toml(scene);
  } catch (const std::invalid_argument&) {
    return "";  // functions or arrays: the JSON settings name them
  }
}

std::string fingerprint_of(Scene scene) {
  scene.title.clear();
  scene.output = {};
  if (!scene.time.steps) {
    scene.time.end = 0.0;
  }
  return fingerprint(to_json(scene));
}

}  // namespace

RunOptions run_options(const Scene& scene) {
  RunOptions options;
  options.output = scene.output.path;
  options.frame_interval = scene.output.every.value_or(0.0);
  options.frame_steps = scene.output.every_steps.value_or(0);
  options.checkpoint = scene.output.checkpoint;
  options.checkpoint_interval_seconds = scene.output.checkpoint_every.value_or(0.0);
  options.scene_text = text_for_record(scene);
  options.settings = to_json(scene);
  options.fingerprint = fingerprint_of(scene);
  return options;
}

}  // namespace lapilli
