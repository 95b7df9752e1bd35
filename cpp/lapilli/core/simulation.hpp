#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/core/thread_chooser.hpp"

namespace lapilli {

/// A clock, the points and an ordered list of physics.
class Simulation {
 public:
  /// How steps are chosen: `fixed_step` > 0 is taken as it is (refused above the hard limit),
  /// otherwise the smallest automatic step of the physics.
  struct Clock {
    double end = 0.0;                                               // s
    double fixed_step = 0.0;                                        // s; 0: automatic
    double largest_step = std::numeric_limits<double>::infinity();  // s, for unlimited physics
  };

  Simulation(std::unique_ptr<Points> points, std::vector<std::unique_ptr<Physics>> physics,
             Clock clock);

  double time() const { return time_; }
  double end() const { return clock_.end; }
  Index step_index() const { return index_; }
  Points& points() { return *points_; }
  const Points& points() const { return *points_; }
  const std::vector<std::unique_ptr<Physics>>& physics() const { return physics_; }

  /// The step the clock would take now. Throws std::invalid_argument above a hard limit, naming the
  /// limit and its reason.
  double next_step_size() const { return next_step().size; }

  /// One step, cut so as not to pass `until`. Throws RunError with step and time when it fails;
  /// after a failure that left fields half evolved every further step throws it again.
  /// `output_due`: whether somebody may look at the fields afterwards even short of `until`;
  /// without it a physics may leave point values for output stale.
  StepReport step(double until = std::numeric_limits<double>::infinity(), bool output_due = true);

  /// Step until `time`, exactly; `after_step` may return false to stop early.
  void run_until(double time, const std::function<bool(const Simulation&)>& after_step = {});

  /// Every field of every physics, brought up to date, "position" excluded.
  std::vector<Field> fields();
  std::vector<Balance> balances() const;

  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  struct NextStep {
    double size;                                            // s
    double stop = std::numeric_limits<double>::infinity();  // s, as in StepLimit
    bool even = false;
  };
  NextStep next_step() const;
  StepReport take_step(double until, bool output_due);
  StepReport advance(double size, bool output_due, bool last);
  void require_whole() const;
  /// After a step: every physics books what they carry, then they are gone.
  void let_points_leave();
  /// Remember the largest amount that every balance has seen.
  void watch_balances();

  std::unique_ptr<Points> points_;
  std::vector<std::unique_ptr<Physics>> physics_;
  Clock clock_;
  double time_ = 0.0;
  Index index_ = 0;
  std::string failure_;          // why the fields are half evolved; empty: they are whole
  std::vector<double> largest_;  // by balance
  ThreadChooser threads_;
};

}  // namespace lapilli
