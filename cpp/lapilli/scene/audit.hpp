#pragma once

#include <string>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Settings that nothing reads in this scene, each with its path and the reason: what a method that
/// was not chosen would read, a start or a material of physics that is not modelled. Only settings
/// that differ from their default are named. The scene must be valid.
std::vector<Note> unused_settings(const Scene& scene);

}  // namespace lapilli
