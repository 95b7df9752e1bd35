#pragma once

#include <string>

#include "lapilli/geometry/triangle_surface.hpp"

namespace lapilli {

/// The triangles of an STL file, binary or text; corners nearer than 1e-7 of the body's size become
/// one vertex. Text may be in capitals and begin with blanks or a byte-order mark; what follows the
/// triangles that a binary header counts is left out. Throws std::invalid_argument naming the file
/// (and line) if it is neither, broken or cut short.
Triangles read_stl(const std::string& path);

}  // namespace lapilli
