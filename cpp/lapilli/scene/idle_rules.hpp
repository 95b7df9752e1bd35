#pragma once

#include <span>

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// A setting, the scenes that do not read it, and why. `[]` stands for any index, whose value is
/// handed on.
struct IdleRule {
  const char* pattern;
  bool (*is_idle)(const Scene& scene, std::size_t index);
  const char* why;
};

/// Of every setting that some scenes do not read.
std::span<const IdleRule> idle_rules();

/// Whether neither method of heat is modelled.
bool without_heat(const Scene& scene);

}  // namespace lapilli
