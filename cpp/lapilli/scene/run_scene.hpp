#pragma once

#include "lapilli/output/runner.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// What run() needs to know of a scene: its output section, its text and all settings for the
/// record, and a fingerprint of everything that shapes the state, so that a run can be resumed with
/// a later end or other frames, never with another problem. Functions are named, not compared.
RunOptions run_options(const Scene& scene);

}  // namespace lapilli
