#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/core/stage_account.hpp"
#include "lapilli/core/thread_chooser.hpp"

namespace lapilli {

/// A clock, the points and an ordered list of physics; in a run of several stages, those of the
/// present one.
class Simulation {
 public:
  /// How steps are chosen: `fixed_step` > 0 is taken as it is (refused above the hard limit),
  /// otherwise the smallest automatic step of the physics.
  struct Clock {
    double end = 0.0;                                               // s
    double fixed_step = 0.0;                                        // s; 0: automatic
    double largest_step = std::numeric_limits<double>::infinity();  // s, for unlimited physics
    double start = 0.0;                                             // s, of a later stage
  };

  /// A later stage of the run. It begins, with points and physics made anew from the state in which
  /// the stage before ended, when the clock goes on beyond that end.
  struct Stage {
    struct Parts {
      std::unique_ptr<Points> points;  // ids go on; see `created_in`
      std::vector<std::unique_ptr<Physics>> physics;
      std::vector<Index> body_numbers;  // that users see, by body of the points
    };
    std::string name;
    Clock clock;
    std::function<Parts(const std::shared_ptr<const Archive>& before)> begin;
  };

  Simulation(std::unique_ptr<Points> points, std::vector<std::unique_ptr<Physics>> physics,
             Clock clock);

  /// Let these stages follow. Before the first step.
  void follow_with(std::vector<Stage> stages) { stages_ = std::move(stages); }
  const std::vector<Stage>& later_stages() const { return stages_; }
  /// The number that users see of each body of the points, the same in all stages; empty where it
  /// is that of the points.
  const std::vector<Index>& body_numbers() const { return body_numbers_; }
  /// Times at which stages end that others follow, s.
  std::vector<double> stage_ends() const;
  /// The present stage; 0 is the one before all that follow.
  std::size_t stage() const { return stage_; }
  std::string stage_name() const { return stage_ == 0 ? "" : stages_[stage_ - 1].name; }
  /// What a state written by `save` says of the number of points created so far.
  static Index created_in(const Archive& state);

  double time() const { return time_; }
  double end() const { return stages_.empty() ? clock_.end : stages_.back().clock.end; }
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
  /// What earlier stages add to the balances and sums of the present physics.
  const StageAccount& account() const { return account_; }

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

  bool is_stage_over() const { return stage_ < stages_.size() && time_ >= clock_.end; }
  void begin_next_stage();
  /// Points and physics of the stage after the present one, from the state before.
  Stage::Parts next_parts(const std::shared_ptr<const Archive>& before) const;
  void replace_parts(Stage::Parts parts, std::shared_ptr<const Archive> before);
  void save_state(Archive& archive) const;
  void save_stage(Archive& archive) const;
  void load_stage(const Archive& archive);

  std::unique_ptr<Points> points_;
  std::vector<std::unique_ptr<Physics>> physics_;
  Clock clock_;
  double time_ = 0.0;
  Index index_ = 0;
  std::string failure_;          // why the fields are half evolved; empty: they are whole
  std::vector<double> largest_;  // by balance
  ThreadChooser threads_;
  std::vector<Stage> stages_;
  std::size_t stage_ = 0;
  std::vector<Index> body_numbers_;
  std::shared_ptr<const Archive>
      stage_start_;  // the state before the present one; null in the first
  StageAccount account_;
};

}  // namespace lapilli
