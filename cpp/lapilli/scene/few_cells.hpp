#pragma once

#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

class Points;

/// A warning for each body of [dynamics] that is so few cells across that its place on the grid
/// tells in its motion.
std::vector<Note> few_cells(const Scene& scene, const Points& points);

}  // namespace lapilli
