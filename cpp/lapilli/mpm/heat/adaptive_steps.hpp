#pragma once

#include <limits>
#include <string>

#include "lapilli/core/archive.hpp"
#include "lapilli/mpm/heat/steps_ahead.hpp"

namespace lapilli {

/// How steps of heat are taken.
enum class SteppingKind {
  explicit_euler,
  stages,   // explicit, of many stages: see ChebyshevStages
  implicit  // TR-BDF2
};

/// Which steps of heat pay, and how long they may be.
///
/// After the start or a jump, temperatures change over spans as long as the time since. Steps that
/// are a fixed share of that time keep one error from there on; explicit ones stay as they are.
/// One of n explicit steps' length costs about the root of n in stages, where the surface bears
/// these, and always the same if it is implicit: the cheapest is taken.
class AdaptiveSteps {
 public:
  AdaptiveSteps() = default;
  /// `tolerance` as a share of the span of temperatures; `explicit_step` in s; an implicit step
  /// costs as much as `worth` explicit ones.
  AdaptiveSteps(double tolerance, double explicit_step, double worth);

  /// Take no longer steps, s, where something changes that fast.
  void bound(double longest) { longest_ = longest; }
  /// Allow stages: rates are at most `rate`, 1/s; not where it is 0.
  void allow_stages(double rate) { stage_rate_ = rate; }

  SteppingKind kind() const { return kind_; }
  bool are_long() const { return kind_ != SteppingKind::explicit_euler; }
  /// Of the next long step, s.
  double size() const { return size_; }
  /// That a step of this size needs.
  int stages(double size) const;

  /// Between steps at `time`: choose how the next ones are taken. Tables had their last jump at
  /// `last_jump` and have their next entry at `next_entry`. Returns whether that changed.
  bool choose(double time, double last_jump, double next_entry);
  /// Whether the error of a step, as a share of the span, is small enough, or nothing shorter is
  /// better.
  bool accepts(double size, double error) const;
  /// What to try after a step of `size` with this error was not accepted, s.
  double shorter(double size, double error) const;
  /// Choose the size of the next step after one of `size` with this error; below 0: not known.
  void follow(double size, double error);
  /// Steps as short as these are better taken explicitly.
  bool is_worth(double size) const;
  /// Take explicit steps again, until longer ones pay anew.
  void give_up(double time);

  /// Add to `all` the steps expected from `time` to `end`, between which tables have no entry and
  /// before which they had their last jump at `last_jump`.
  void count(double time, double end, double last_jump, StepsAhead& all) const;
  /// Of the next step, in explicit ones.
  double cost() const { return cost_of(kind_, size_); }

  std::string reason() const;
  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  double share() const;       // of the time since a jump
  double least_size() const;  // s, of steps in stages
  double first_size(double time, double since) const;
  double cost_of(SteppingKind kind, double size) const;
  SteppingKind cheapest(double size) const;

  double tolerance_ = 0.0, allowed_ = 0.0;  // of the whole run, of one step
  double explicit_step_ = 0.0, worth_ = 0.0;
  double stage_rate_ = 0.0;                                   // 1/s
  double longest_ = std::numeric_limits<double>::infinity();  // s
  SteppingKind kind_ = SteppingKind::explicit_euler;
  double size_ = 0.0;   // s
  double since_ = 0.0;  // s, from where the time since is counted: a jump, or the last failure
};

}  // namespace lapilli
