#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/geometry/bounds.hpp"
#include "lapilli/geometry/image_file.hpp"

namespace lapilli {

class PixelDistance;

/// The bright (or dark) pixels of an image, in the x-y plane; infinite along z. The image stands
/// upright: its first row is on top. The distance is that to the outline of the pixels (see
/// PixelOutline): edges along the axes are those of pixels, others a smoothed staircase, right
/// within a pixel.
struct ImageMask {
  static constexpr const char* kind = "image";
  std::string file;                         // PNG, PGM or PPM; or values
  std::vector<std::vector<double>> values;  // brightness 0 to 1, rows from the top
  double pixel = 1.0;                       // m, side of a pixel
  std::vector<double> origin = {0.0, 0.0};  // m, lower left corner of the image
  double threshold = 0.5;                   // of brightness, 0 to 1
  bool dark = false;                        // inside is below the threshold, not above

  /// What `check` made of the members above; copies share it.
  mutable std::shared_ptr<const PixelDistance> pixels;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("file").file().text("PNG, PGM or PPM image"), self.file);
    visit(Key("values").text("brightness 0 to 1, rows from the top, where no file is given"),
          self.values);
    visit(Key("pixel").unit("m").positive().required().text("side of a pixel"), self.pixel);
    visit(Key("origin").unit("m").text("lower left corner of the image"), self.origin);
    visit(Key("threshold").range(0.0, 1.0).text("brightness from which a pixel is inside"),
          self.threshold);
    visit(Key("dark").text("pixels below the threshold are inside instead"), self.dark);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// Which pixels of an image are inside, and their signed distances.
class PixelDistance {
 public:
  /// `inside` is height x width, rows from the bottom; at least one pixel must be set.
  PixelDistance(int width, int height, const std::vector<bool>& inside);

  int width() const { return width_; }
  int height() const { return height_; }
  bool inside(int column, int row) const { return sample(column, row) < 0.0; }
  /// Signed distance in pixels at a place in pixels from the lower left corner, to a pixel or so.
  double at(double x, double y) const;

 private:
  // Distance at a pixel centre; one row of pixels around the image, all outside, is held as well.
  double sample(int column, int row) const {
    const auto before = static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(width_ + 2);
    return distance_[before + static_cast<std::size_t>(column + 1)];
  }

  int width_, height_;
  std::vector<double> distance_;
};

/// The pixels of a checked mask.
const PixelDistance& pixels_of(const ImageMask& mask);

}  // namespace lapilli
