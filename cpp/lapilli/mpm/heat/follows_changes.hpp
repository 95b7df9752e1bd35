#pragma once

namespace lapilli {

/// Heat that chooses long steps, and has to know what else changes in the course of a run.
class FollowsChanges {
 public:
  virtual ~FollowsChanges() = default;
  /// Before the first step: `end` of the run, s, and the `longest` steps that follow the motion of
  /// bodies past conditions in space, s.
  virtual void follow_changes(double end, double longest) = 0;
};

}  // namespace lapilli
