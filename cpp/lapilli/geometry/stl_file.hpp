#pragma once

#include <string>

#include "lapilli/geometry/triangle_surface.hpp"

namespace lapilli {

/// The triangles of an STL file, binary or text; vertices of the same coordinates become one.
/// Throws std::invalid_argument naming the file and, in text, the line.
Triangles read_stl(const std::string& path);

}  // namespace lapilli
