#pragma once

#include "lapilli/output/runner.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// What run() needs to know of a scene: its output section, its text and all settings for the
/// record, and a fingerprint of everything that shapes the state, so that a run can be resumed with
/// a later end or other frames, never with another problem. Functions are named, not compared.
RunOptions run_options(const Scene& scene);

/// The same with the volumes of the bodies, for a simulation that has just been built.
RunOptions run_options(const Scene& scene, const Points& points);

/// The scene with the output that a front end was asked for: frames in `path`, unless it is empty,
/// and after `every` seconds, unless it is 0, whatever the scene says of steps between frames.
Scene with_output(Scene scene, const std::string& path, double every);

/// The files that a scene and its stages read.
std::vector<std::filesystem::path> inputs_of(const Scene& scene);

/// What of a scene's fields goes into its frames, and how.
FrameOptions frame_options(const Scene& scene);

/// The probes of a scene, in its order.
std::vector<Probe> probes_of(const Scene& scene);

}  // namespace lapilli
