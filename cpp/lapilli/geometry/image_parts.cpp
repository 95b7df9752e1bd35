#include "lapilli/geometry/image_parts.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace lapilli {

ImageParts::ImageParts(const Placed<ImageMask>& image, const Sites& sites)
    : pixels_(pixels_of(*image.shape)), side_(sites.spacing()) {
  const double pixel = image.shape->pixel;
  const Mat3 back = image.turn.transpose();
  const Vec3 origin = place(image.shape->origin);
  turn_ = back * sites.turn() / pixel;
  shift_ = (back * (sites.to_scene(Vec3::Zero()) - image.shift) - origin) / pixel;
}

MomentSum ImageParts::of(const Vec3& corner) const {
  // The box as the image sees it, cut into rows of pixels, these into runs of set ones.
  Outline box;
  for (const Vec<2>& at : rectangle({0, 0}, {side_, side_})) {
    box.push_back((turn_ * (corner + Vec3(at[0], at[1], 0.0)) + shift_).head<2>());
  }
  Vec<2> low = box[0], high = box[0];
  for (const Vec<2>& at : box) {
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  const auto pixel_at = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, count - 1.0));
  };
  const Vec<2> origin = (turn_ * corner + shift_).head<2>();
  MomentSum seen;
  for (int row = pixel_at(low[1], pixels_.height()); row <= pixel_at(high[1], pixels_.height());
       ++row) {
    const Cut<2> strip[] = {{{0, -1}, -static_cast<double>(row)}, {{0, 1}, row + 1.0}};
    const Outline in_row = clip_polygon(box, strip);
    const int end = pixel_at(high[0], pixels_.width());
    for (int column = pixel_at(low[0], pixels_.width()); column <= end; ++column) {
      if (!pixels_.inside(column, row)) {
        continue;
      }
      const int first = column;
      while (column < end && pixels_.inside(column + 1, row)) {
        ++column;
      }
      const Cut<2> run[] = {{{-1, 0}, -static_cast<double>(first)}, {{1, 0}, column + 1.0}};
      seen.add(1.0, moment_sum(clip_polygon(in_row, run), origin));
    }
  }
  // Back into the frame of the lattice: lengths in metres, directions turned back.
  const Mat3 back = turn_.inverse();
  const double area = std::abs(back.topLeftCorner<2, 2>().determinant());
  MomentSum sum;
  sum.volume = area * seen.volume;
  sum.first = area * back * seen.first;
  sum.second = area * back * seen.second * back.transpose();
  return sum;
}

}  // namespace lapilli
