#pragma once

#include "lapilli/output/runner.hpp"

namespace lapilli {

/// Shows how far a run has come: one line that is redrawn on a terminal, a plain line at every
/// tenth of the way otherwise, nothing when quiet.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { finish(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  /// End the line that is being redrawn.
  void finish();

 private:
  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  int tenths_shown_ = -1;
};

}  // namespace lapilli
