#pragma once

#include <string>

#include "lapilli/geometry/image_file.hpp"

namespace lapilli {

/// Whether these bytes begin as a PNG file does.
bool is_png(const std::string& bytes);

/// A PNG image of any colour type and depth (to 16 bits): colours become brightness by their mean,
/// transparent pixels stand before white. Throws std::invalid_argument naming `path` for broken
/// files and images of more than 100,000 pixels a side.
Image png_image(const std::string& bytes, const std::string& path);

}  // namespace lapilli
