#pragma once

#include "lapilli/scene/check.hpp"

namespace lapilli {

/// What the settings of a scene model and what they leave out, and notes on them.
void describe_model(const Scene& scene, CheckReport& report);

}  // namespace lapilli
