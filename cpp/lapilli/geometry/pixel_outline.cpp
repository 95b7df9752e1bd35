#include "lapilli/geometry/pixel_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lapilli {
namespace {

// Corners show 1/16, edges of any slope 1/8 or more.
constexpr double told = 0.1;
// What the distance between pixel centres may miss of that to the outline.
constexpr double slack = 1.5;

double sign_of(double level) { return level < 0.0 ? -1.0 : 1.0; }

bool is_left(const Vec<2>& place, const Vec<2>& begin, const Vec<2>& end) {
  const Vec<2> along = end - begin, to = place - begin;
  return along[0] * to[1] - along[1] * to[0] > 0.0;
}

}  // namespace

PixelOutline::PixelOutline(int width, int height, const std::vector<bool>& inside)
    : PixelDistance(width, height, inside), begin_{0} {
  std::vector<double> below(static_cast<std::size_t>(width) + 2, 0.5), above = below;
  for (int row = -1; row < height; ++row) {
    for (int column = -1; column <= width; ++column) {
      above[static_cast<std::size_t>(column + 1)] = level(column, row + 1);
    }
    for (int column = -1; column < width; ++column) {
      const auto k = static_cast<std::size_t>(column + 1);
      add_pieces(column, row, {below[k], below[k + 1], above[k + 1], above[k]});
      begin_.push_back(pieces_.size());
    }
    below.swap(above);
  }
}

bool PixelOutline::set(int column, int row) const {
  return column >= 0 && row >= 0 && column < width() && row < height() &&
         PixelDistance::inside(column, row);
}

double PixelOutline::level(int column, int row) const {
  double mean = 0.0;
  for (int up = -1; up <= 1; ++up) {
    for (int right = -1; right <= 1; ++right) {
      mean += set(column + right, row + up) ? (2 - std::abs(right)) * (2 - std::abs(up)) : 0;
    }
  }
  const double outside = 0.5 - mean / 16.0, sign = set(column, row) ? -1.0 : 1.0;
  return sign * outside > told ? outside : 0.5 * sign;
}

void PixelOutline::add_pieces(int column, int row, const std::array<double, 4>& levels) {
  constexpr int right[] = {0, 1, 1, 0}, up[] = {0, 0, 1, 1};
  // Where the outline crosses the sides of the square, counter-clockwise.
  std::array<Vec<2>, 4> crossing;
  std::array<bool, 4> leaves{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4;
    if ((levels[k] < 0.0) == (levels[next] < 0.0)) {
      continue;
    }
    // A level that says little puts the crossing halfway, whatever the other one says.
    const bool halfway = std::abs(levels[k]) == 0.5 || std::abs(levels[next]) == 0.5;
    const double share = halfway ? 0.5 : levels[k] / (levels[k] - levels[next]);
    const Vec<2> from(column + 0.5 + right[k], row + 0.5 + up[k]);
    const Vec<2> to(column + 0.5 + right[next], row + 0.5 + up[next]);
    crossing[count] = from + share * (to - from);
    leaves[count++] = levels[k] < 0.0;
  }
  if (count == 2) {
    // A pixel alone that is at a corner of the shape, or in the end of a strip, keeps its corner.
    const std::size_t from = leaves[0] ? 0 : 1;
    const double sum =
        sign_of(levels[0]) + sign_of(levels[1]) + sign_of(levels[2]) + sign_of(levels[3]);
    for (const double level : levels) {
      if (level * sum < 0.0 && std::abs(level) == 0.5) {
        const Vec<2> corner(column + 1.0, row + 1.0);
        pieces_.push_back({crossing[from], corner, level < 0.0});
        pieces_.push_back({corner, crossing[1 - from], level < 0.0});
        return;
      }
    }
  }
  const bool joined = levels[0] + levels[1] + levels[2] + levels[3] < 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    if (leaves[k]) {
      const std::size_t other = (k + (joined ? 1 : count - 1)) % count;
      pieces_.push_back({crossing[k], crossing[other], joined});
    }
  }
}

bool PixelOutline::covers(const Vec<2>& place) const {
  const int column = static_cast<int>(std::clamp(std::floor(place[0] - 0.5), -2.0, width() + 0.0));
  const int row = static_cast<int>(std::clamp(std::floor(place[1] - 0.5), -2.0, height() + 0.0));
  if (column < -1 || row < -1 || column >= width() || row >= height()) {
    return false;
  }
  const std::size_t here = square(column, row);
  const std::size_t count = begin_[here + 1] - begin_[here];
  if (count == 0) {
    return set(column, row);
  }
  const Piece& first = pieces_[begin_[here]];
  const bool left = is_left(place, first.begin, first.end);
  if (count == 1) {
    return left;
  }
  const Piece& second = pieces_[begin_[here] + 1];
  const bool left_of_second = is_left(place, second.begin, second.end);
  return first.left_of_both ? left && left_of_second : left || left_of_second;
}

PixelOutline::Nearest PixelOutline::nearest(const Vec<2>& place) const {
  const Vec<2> known(std::clamp(place[0], 0.0, width() + 0.0),
                     std::clamp(place[1], 0.0, height() + 0.0));
  const double reach = std::abs(at(known[0], known[1])) + (place - known).norm() + slack;
  const auto within = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at - 0.5), -1.0, count - 1.0));
  };
  const int first = within(place[0] - reach, width()), last = within(place[0] + reach, width());
  const int middle = within(place[1], height());
  double least = std::numeric_limits<double>::infinity();
  const Piece* nearest = nullptr;
  Vec<2> foot = place;
  const auto search = [&](int row) {
    for (std::size_t k = begin_[square(first, row)]; k < begin_[square(last, row) + 1]; ++k) {
      const Vec<2> along = pieces_[k].end - pieces_[k].begin;
      const double share = along.dot(place - pieces_[k].begin) / along.squaredNorm();
      const Vec<2> there = pieces_[k].begin + std::clamp(share, 0.0, 1.0) * along;
      const double squared = (there - place).squaredNorm();
      if (squared < least) {
        least = squared;
        nearest = &pieces_[k];
        foot = there;
      }
    }
  };
  // Rows from the nearest one on, until they are farther than what was found.
  const auto is_near = [&](int row) {
    const double away = std::max(std::abs(place[1] - row - 1.0) - 0.5, 0.0);
    return away * away < least;
  };
  for (int row = middle; row < height() && is_near(row); ++row) {
    search(row);
  }
  for (int row = middle - 1; row >= -1 && is_near(row); --row) {
    search(row);
  }
  const double sign = covers(place) ? -1.0 : 1.0, distance = std::sqrt(least);
  if (distance > 1e-9) {
    return {sign * distance, sign / distance * (place - foot)};
  }
  const Vec<2> along = nearest->end - nearest->begin;
  return {sign * distance, Vec<2>(along[1], -along[0]).normalized()};
}

const PixelOutline& outline_of(const ImageMask& mask) {
  // `check` makes no other pixels.
  return static_cast<const PixelOutline&>(pixels_of(mask));
}

}  // namespace lapilli
