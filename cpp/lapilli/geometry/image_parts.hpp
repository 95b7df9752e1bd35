#pragma once

#include "lapilli/geometry/flat.hpp"
#include "lapilli/geometry/lattice.hpp"
#include "lapilli/geometry/moment_sum.hpp"

namespace lapilli {

/// The part of lattice boxes covered by the set pixels of an image, exact to rounding.
class ImageParts {
 public:
  ImageParts(const Placed<ImageMask>& image, const Sites& sites);

  /// Moments about `corner`, the lower corner of a box.
  MomentSum of(const Vec3& corner) const;

 private:
  const PixelDistance& pixels_;
  double side_;
  Mat3 turn_;  // from the frame of the lattice to that of the image, in pixels
  Vec3 shift_;
};

}  // namespace lapilli
