#include "lapilli/geometry/image_mask.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/pixel_outline.hpp"

namespace lapilli {
namespace {

constexpr double far_away = 1e20;

// Lower envelope of the parabolas value[k] + (x - k)^2 (Felzenszwalb and Huttenlocher 2012).
void lower_envelope(std::vector<double>& value) {
  const int count = static_cast<int>(value.size());
  std::vector<int> root(value.size(), 0);
  std::vector<double> from(value.size() + 1), result(value.size());
  const auto at = [&](int k) { return value[static_cast<std::size_t>(k)]; };
  int last = 0;
  from[0] = -far_away;
  from[1] = far_away;
  for (int q = 1; q < count; ++q) {
    double meet = 0.0;
    for (;; --last) {
      const int p = root[static_cast<std::size_t>(last)];
      meet = ((at(q) + q * q) - (at(p) + p * p)) / (2.0 * (q - p));
      if (meet > from[static_cast<std::size_t>(last)] || last == 0) {
        break;
      }
    }
    if (meet > from[static_cast<std::size_t>(last)]) {
      ++last;
    }
    root[static_cast<std::size_t>(last)] = q;
    from[static_cast<std::size_t>(last)] = meet;
    from[static_cast<std::size_t>(last) + 1] = far_away;
  }
  int piece = 0;
  for (int q = 0; q < count; ++q) {
    while (from[static_cast<std::size_t>(piece) + 1] < q) {
      ++piece;
    }
    const int p = root[static_cast<std::size_t>(piece)];
    result[static_cast<std::size_t>(q)] = at(p) + static_cast<double>(q - p) * (q - p);
  }
  value = result;
}

// Distance from each pixel centre to the nearest marked one.
std::vector<double> distance_to(const std::vector<bool>& marked, int width, int height) {
  std::vector<double> squared(marked.size());
  for (std::size_t k = 0; k < marked.size(); ++k) {
    squared[k] = marked[k] ? 0.0 : far_away;
  }
  const auto sweep = [&](int lines, int length, int line_stride, int stride) {
    std::vector<double> line(static_cast<std::size_t>(length));
    for (int k = 0; k < lines; ++k) {
      for (int i = 0; i < length; ++i) {
        line[static_cast<std::size_t>(i)] =
            squared[static_cast<std::size_t>(k * line_stride + i * stride)];
      }
      lower_envelope(line);
      for (int i = 0; i < length; ++i) {
        squared[static_cast<std::size_t>(k * line_stride + i * stride)] =
            line[static_cast<std::size_t>(i)];
      }
    }
  };
  sweep(height, width, width, 1);
  sweep(width, height, 1, width);
  for (double& value : squared) {
    value = std::sqrt(value);
  }
  return squared;
}

Image given_image(const ImageMask& mask) {
  Image image;
  image.height = static_cast<int>(mask.values.size());
  image.width = static_cast<int>(mask.values.front().size());
  for (std::size_t row = 0; row < mask.values.size(); ++row) {
    require(static_cast<int>(mask.values[row].size()) == image.width && image.width > 0,
            "image: rows of values must be of one length, row 0 has ", image.width, ", row ", row,
            " has ", mask.values[row].size());
    for (std::size_t column = 0; column < mask.values[row].size(); ++column) {
      const double value = mask.values[row][column];
      require(value >= 0.0 && value <= 1.0, "image: brightness must be 0 to 1, got ", value,
              " in row ", row, ", column ", column,
              value > 1.0 && value <= 255.0 ? "; divide values of 8 bits by 255" : "");
    }
    image.brightness.insert(image.brightness.end(), mask.values[row].begin(),
                            mask.values[row].end());
  }
  return image;
}

Vec<2> in_pixels(const ImageMask& mask, const Vec3& x) {
  return {(x[0] - mask.origin[0]) / mask.pixel, (x[1] - mask.origin[1]) / mask.pixel};
}

}  // namespace

PixelDistance::PixelDistance(int width, int height, const std::vector<bool>& inside)
    : width_(width), height_(height) {
  const int wide = width + 2, high = height + 2;
  std::vector<bool> set(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), false);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      set[static_cast<std::size_t>((row + 1) * wide + column + 1)] =
          inside[static_cast<std::size_t>(row * width + column)];
    }
  }
  std::vector<bool> unset = set;
  unset.flip();
  const std::vector<double> outwards = distance_to(set, wide, high);
  const std::vector<double> inwards = distance_to(unset, wide, high);
  for (std::size_t k = 0; k < set.size(); ++k) {
    distance_.push_back(set[k] ? 0.5 - inwards[k] : outwards[k] - 0.5);
  }
}

double PixelDistance::at(double x, double y) const {
  // Centres of the outermost pixels held are half a pixel beyond the image.
  const double u = std::clamp(x, -0.5, width_ + 0.5), v = std::clamp(y, -0.5, height_ + 0.5);
  const int column = std::min(static_cast<int>(std::floor(u - 0.5)), width_ - 1);
  const int row = std::min(static_cast<int>(std::floor(v - 0.5)), height_ - 1);
  const double s = u - 0.5 - column, t = v - 0.5 - row;
  const double below = (1.0 - s) * sample(column, row) + s * sample(column + 1, row);
  const double above = (1.0 - s) * sample(column, row + 1) + s * sample(column + 1, row + 1);
  const double within = (1.0 - t) * below + t * above;
  const double beyond_squared = (x - u) * (x - u) + (y - v) * (y - v);
  return beyond_squared > 0.0 ? std::sqrt(within * within + beyond_squared) : within;
}

const PixelDistance& pixels_of(const ImageMask& mask) {
  require(mask.pixels != nullptr,
          "image: asked before it was checked; call check(shape, dimension) first");
  return *mask.pixels;
}

double ImageMask::distance(const Vec3& x) const {
  return pixel * outline_of(*this).nearest(in_pixels(*this, x)).distance;
}

Vec3 ImageMask::gradient(const Vec3& x) const {
  Vec3 slope = Vec3::Zero();
  slope.head<2>() = outline_of(*this).nearest(in_pixels(*this, x)).normal;
  return slope;
}

Bounds ImageMask::bounds() const {
  const PixelDistance& mask = pixels_of(*this);
  int first_column = mask.width(), last_column = 0, first_row = mask.height(), last_row = 0;
  for (int row = 0; row < mask.height(); ++row) {
    for (int column = 0; column < mask.width(); ++column) {
      if (mask.inside(column, row)) {
        first_column = std::min(first_column, column);
        last_column = std::max(last_column, column + 1);
        first_row = std::min(first_row, row);
        last_row = std::max(last_row, row + 1);
      }
    }
  }
  Bounds all;
  all.lower.head<2>() = Vec<2>(origin[0] + pixel * first_column, origin[1] + pixel * first_row);
  all.upper.head<2>() = Vec<2>(origin[0] + pixel * last_column, origin[1] + pixel * last_row);
  return all;
}

void ImageMask::check(int dimension) const {
  require_dimension(dimension, 2, kind, "a box");
  require_positive(pixel, kind, "pixel");
  require_numbers(origin, 2, 2, kind, "origin");
  require(threshold >= 0.0 && threshold <= 1.0, "image: threshold must be 0 to 1, got ", threshold);
  require(file.empty() != values.empty(),
          file.empty() ? "image: give a file or values" : "image: give a file or values, not both");
  const Image image = file.empty() ? given_image(*this) : read_image(file);
  std::vector<bool> inside;
  for (int row = image.height - 1; row >= 0; --row) {
    for (int column = 0; column < image.width; ++column) {
      inside.push_back((image.at(column, row) >= threshold) != dark);
    }
  }
  require(std::find(inside.begin(), inside.end(), true) != inside.end(), "image: no pixel",
          file.empty() ? "" : " of ", file, " is ", dark ? "below" : "at or above",
          " the threshold ", threshold);
  pixels = std::make_shared<const PixelOutline>(image.width, image.height, inside);
}

}  // namespace lapilli
