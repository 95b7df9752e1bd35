#pragma once

#include <string>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Temperatures below absolute zero where surfaces radiate, numbers and tables; throws
/// std::invalid_argument with the place of the key. Functions are checked where they are called.
void validate_heat(const Scene& scene);

/// Whether heat is solved with the operators of points. The scene has [heat].
bool is_heat_of_points(const Scene& scene);

/// What is not wrong but looks like a slip or costs accuracy: temperatures under radiation that
/// look like degrees Celsius, melting points and axes, surfaces known by points alone, strong
/// convection.
std::vector<Note> heat_warnings(const Scene& scene);

}  // namespace lapilli
