#pragma once

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// When a run writes frames: at the start, at every whole multiple of an interval of time (or after
/// every so many steps), and at the end. Multiples are computed, not added up.
class FrameSchedule {
 public:
  /// `interval` in s, or `steps` between frames; both 0: the first and the last frame only. Throws
  /// std::invalid_argument when one is negative, not finite, or both are given.
  FrameSchedule(double interval, Index steps, double end);

  /// Time up to which the clock may step before a frame is due: the next multiple or the end.
  double next_time(double time) const;
  /// Whether a frame at this time and step would also be written by a run that ends later.
  bool is_due(double time, Index step) const;
  /// Whether a frame was due between two times, ends excluded.
  bool is_passed(double from, double to) const { return interval_ > 0.0 && next_time(from) < to; }
  /// How many frames to expect in all; 0 when that depends on the steps.
  Index planned() const;

 private:
  bool reaches_end(double time) const { return time >= end_ - 1e-9 * interval_; }

  double interval_;
  Index steps_;
  double end_;
};

}  // namespace lapilli
