#pragma once

#include <functional>
#include <memory>
#include <stdexcept>

#include "lapilli/core/interruption.hpp"

namespace lapilli {

/// A step that was asked to stop on its way and is as not begun.
class StepStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// While one lives, steps of its thread that can take back what they did ask from time to time
/// whether they are `unwanted` by now: a step of many seconds need not come to its end.
class StepStop {
 public:
  explicit StepStop(std::function<bool()> unwanted);
  ~StepStop();
  StepStop(const StepStop&) = delete;
  StepStop& operator=(const StepStop&) = delete;

  /// For the part of a step that changes nothing for good: while it lives the step may be left by
  /// StepStopped. Null where nobody asks.
  static std::unique_ptr<Interruption> stoppable();

 private:
  std::function<bool()> unwanted_;
  StepStop* outer_;
};

}  // namespace lapilli
