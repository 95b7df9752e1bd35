#pragma once

#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// When a run writes frames: at the start, at every whole multiple of an interval of time (or after
/// every so many steps), at the ends of stages, and at the end. Multiples are computed, not added
/// up.
class FrameSchedule {
 public:
  /// `interval` in s, or `steps` between frames; both 0: the first and the last frame only. Throws
  /// std::invalid_argument when one is negative, not finite, or both are given.
  /// `stops`: ends of stages before the last, rising.
  FrameSchedule(double interval, Index steps, double end, std::vector<double> stops = {});

  /// Time up to which the clock may step before a frame is due: the next multiple or the end.
  double next_time(double time) const;
  /// Whether a frame at this time and step would also be written by a run that ends later.
  bool is_due(double time, Index step) const;
  /// Whether a frame was due between two times, ends excluded.
  bool is_passed(double from, double to) const { return interval_ > 0.0 && next_time(from) < to; }
  /// How many frames to expect in all; 0 when that depends on the steps.
  Index planned() const;

 private:
  bool reaches(double stop, double time) const { return time >= stop - 1e-9 * interval_; }

  double interval_;
  Index steps_;
  double end_;
  std::vector<double> stops_;
};

}  // namespace lapilli
