#pragma once

#include <array>
#include <vector>

#include "lapilli/core/vector.hpp"
#include "lapilli/geometry/image_mask.hpp"

namespace lapilli {

/// The pixels of an image with the outline of those inside: straight pieces across the squares
/// between four pixel centres. Edges along the axes, corners between them and strips of one pixel
/// are those of the pixels; stairs are smoothed by the mean of the pixels around, or slanted edges
/// would be up to 8 % too long. Lengths are in pixels from the lower left corner.
class PixelOutline final : public PixelDistance {
 public:
  PixelOutline(int width, int height, const std::vector<bool>& inside);

  struct Nearest {
    double distance;  // negative inside
    Vec<2> normal;    // unit, the way in which the distance grows
  };
  Nearest nearest(const Vec<2>& place) const;

 private:
  struct Piece {
    Vec<2> begin, end;  // the inside is to the left
    bool left_of_both;  // where two cross a square: whether it is inside both, or either
  };

  bool set(int column, int row) const;
  /// How far a pixel is outside, by the mean of those around; 0.5 either way where that says
  /// little: at corners and in thin strips.
  double level(int column, int row) const;
  void add_pieces(int column, int row, const std::array<double, 4>& levels);
  /// Index of a square by the pixel whose centre is its lower left corner, from -1.
  std::size_t square(int column, int row) const {
    return static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(width() + 1) +
           static_cast<std::size_t>(column + 1);
  }
  bool covers(const Vec<2>& place) const;

  std::vector<Piece> pieces_;       // square by square
  std::vector<std::size_t> begin_;  // squares + 1
};

/// The outline of a checked mask.
const PixelOutline& outline_of(const ImageMask& mask);

}  // namespace lapilli
