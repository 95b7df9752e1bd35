#pragma once

namespace lapilli {

/// What a run has before it, by estimate.
struct StepsAhead {
  double settled = 0.0;  // s, what steps grow to once what began or jumped has passed
  // Of steps that are chosen; zero where all are alike:
  double number = 0.0;
  double cost = 0.0;  // as many explicit steps take as long
  double next = 1.0;  // the same of the next step alone
};

/// Heat whose steps are short at first, or of several kinds.
class TellsStepsAhead {
 public:
  virtual ~TellsStepsAhead() = default;
  /// From now to the end of the run.
  virtual StepsAhead steps_ahead() const = 0;
};

}  // namespace lapilli
