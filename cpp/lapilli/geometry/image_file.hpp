#pragma once

#include <string>
#include <vector>

namespace lapilli {

/// Brightness of pixels, rows from the top, 0 (black) to 1 (white).
struct Image {
  int width = 0, height = 0;
  std::vector<double> brightness;  // height x width

  double at(int column, int row) const {
    return brightness[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
  }
};

/// An image file in PNG, PGM or PPM form (P2, P3, P5, P6; 8 or 16 bits); colours become brightness
/// by their mean. Throws std::invalid_argument naming the file for other forms and broken files.
Image read_image(const std::string& path);

}  // namespace lapilli
