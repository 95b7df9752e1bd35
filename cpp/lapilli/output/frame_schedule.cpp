#include "lapilli/output/frame_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lapilli/core/require.hpp"

namespace lapilli {

FrameSchedule::FrameSchedule(double interval, Index steps, double end, std::vector<double> stops)
    : interval_(interval), steps_(steps), end_(end), stops_(std::move(stops)) {
  require(std::isfinite(interval) && interval >= 0.0,
          "the time between frames must be positive (or 0 for the first and last frame only), got ",
          interval, " s");
  require(steps >= 0, "the steps between frames must be positive, got ", steps);
  require(interval == 0.0 || steps == 0,
          "frames come after a time or after a number of steps: give one of them");
  // Beyond this many, multiples of the interval are no longer told apart from the end.
  require(interval == 0.0 || end / interval < 1e8, "frames every ", interval, " s until ", end,
          " s are more than 1e8");
}

double FrameSchedule::next_time(double time) const {
  const auto next = std::ranges::upper_bound(stops_, time);
  const double stop = next == stops_.end() ? end_ : *next;
  if (interval_ == 0.0) {
    return stop;
  }
  double count = std::floor(time / interval_);
  while (count * interval_ <= time) {
    ++count;
  }
  return reaches(stop, count * interval_) ? stop : count * interval_;
}

bool FrameSchedule::is_due(double time, Index step) const {
  if (std::ranges::binary_search(stops_, time)) {
    return true;
  }
  if (steps_ > 0) {
    return step % steps_ == 0;
  }
  if (interval_ == 0.0) {
    return false;
  }
  const double multiple = std::round(time / interval_) * interval_;
  return multiple == time || (time == end_ && std::abs(multiple - end_) <= 1e-9 * interval_);
}

Index FrameSchedule::planned() const {
  if (steps_ > 0) {
    return 0;
  }
  // The first, the multiples, and one more for the end or an interruption.
  const double multiples = interval_ > 0.0 ? std::floor(end_ / interval_ + 1e-9) : 0.0;
  return static_cast<Index>(multiples + static_cast<double>(stops_.size())) + 2;
}

}  // namespace lapilli
