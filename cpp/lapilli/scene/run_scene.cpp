#include "lapilli/scene/run_scene.hpp"

#include "lapilli/output/checksum.hpp"
#include "lapilli/scene/identity.hpp"
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
  SceneIdentity identity = identity_of(scene);
  options.fingerprint = fingerprint(identity.lines);
  options.identity = std::move(identity.lines);
  options.not_compared = std::move(identity.not_compared);
  return options;
}

}  // namespace lapilli
