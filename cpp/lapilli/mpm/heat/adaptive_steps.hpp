#pragma once

#include <limits>
#include <string>

#include "lapilli/core/archive.hpp"

namespace lapilli {

/// When implicit steps of heat pay, and how long they may be.
///
/// After the start or a jump, temperatures change over spans as long as the time since. Implicit
/// steps that are a fixed share of that time keep one error from there on, explicit ones stay as
/// they are: implicit ones pay once that share is longer than the explicit steps they cost.
class AdaptiveSteps {
 public:
  AdaptiveSteps() = default;
  /// `tolerance` as a share of the span of temperatures; `explicit_step` in s; an implicit step
  /// costs as much as `worth` explicit ones.
  AdaptiveSteps(double tolerance, double explicit_step, double worth);

  /// Take no implicit step that is longer, s, where something changes that fast.
  void bound(double longest) { longest_ = longest; }

  bool are_implicit() const { return implicit_; }
  /// Of the next implicit step, s.
  double size() const { return size_; }

  /// Between steps at `time`: choose how the next ones are taken. Tables had their last jump at
  /// `last_jump` and have their next entry at `next_entry`. Returns whether that changed.
  bool choose(double time, double last_jump, double next_entry);
  /// Whether the error of a step, as a share of the span, is small enough.
  bool accepts(double error) const { return error <= 2.5 * allowed_; }
  /// What to try after a step of `size` with this error was not accepted, s.
  double shorter(double size, double error) const;
  /// Choose the size of the next step after one of `size` with this error.
  void follow(double size, double error);
  /// Steps as short as these are better taken explicitly.
  bool is_worth(double size) const { return size >= 0.5 * worth_ * explicit_step_; }
  /// Take explicit steps again, until longer ones pay anew.
  void give_up(double time);

  std::string reason() const;
  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  double tolerance_ = 0.0, allowed_ = 0.0;  // of the whole run, of one step
  double explicit_step_ = 0.0, worth_ = 0.0;
  double longest_ = std::numeric_limits<double>::infinity();  // s
  bool implicit_ = false;
  double size_ = 0.0;   // s
  double since_ = 0.0;  // s, from where the time since is counted: a jump, or the last failure
};

}  // namespace lapilli
