#include "lapilli/core/simulation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "lapilli/core/extensive_unit.hpp"
#include "lapilli/core/memory.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/step_refused.hpp"
#include "lapilli/core/step_stop.hpp"
#include "lapilli/core/thread_limit.hpp"

namespace lapilli {
namespace {

constexpr Index balance_every = 128;  // steps

/// One policy for every physics: nobody is shown a value that is not finite.
void require_finite(const std::vector<Field>& fields, const Points& points, double time) {
  for (const Field& field : fields) {
    const auto bad = std::find_if(field.values.begin(), field.values.end(),
                                  [](double value) { return !std::isfinite(value); });
    if (bad != field.values.end()) {
      const auto row = static_cast<std::size_t>((bad - field.values.begin()) / field.components);
      throw RunError(message("time ", time, " s: ", field.name, " of point ", points.id()[row],
                             " is not finite; a condition gave such a value, or the step is too "
                             "large"));
    }
  }
}

}  // namespace

Simulation::Simulation(std::unique_ptr<Points> points,
                       std::vector<std::unique_ptr<Physics>> physics, Clock clock)
    : points_(std::move(points)), physics_(std::move(physics)), clock_(clock) {
  require(!physics_.empty(), "the scene contains no physics: add a section such as [heat]");
  next_step_size();
  watch_balances();
}

Simulation::NextStep Simulation::next_step() const {
  NextStep next{clock_.fixed_step > 0.0 ? clock_.fixed_step : clock_.largest_step};
  double& size = next.size;
  for (const auto& physics : physics_) {
    const StepLimit limit = physics->step_limit();
    if (clock_.fixed_step > 0.0) {
      require(clock_.fixed_step <= limit.hard * (1.0 + 1e-12), "time.step of ", clock_.fixed_step,
              " s is above the limit of ", limit.hard, " s (", physics->name(), ": ", limit.reason,
              ")");
    } else {
      size = std::min(size, limit.automatic);
      next.stop = std::min(next.stop, limit.stop);
      next.even = next.even || limit.even;
    }
  }
  require(std::isfinite(size) && size > 0.0,
          "no physics of this scene limits the step: give time.step or time.steps");
  return next;
}

void Simulation::require_whole() const {
  if (!failure_.empty()) {
    throw RunError("this simulation cannot go on, its last step failed half way (" + failure_ +
                   "): build it anew, or resume from its checkpoint");
  }
}

StepReport Simulation::step(double until, bool output_due) {
  using Timer = std::chrono::steady_clock;
  require_whole();
  if (chosen_thread_count() > 0) {
    return take_step(until, output_due);
  }
  const ThreadLimit limit(threads_.threads(thread_count()));
  const Timer::time_point start = Timer::now();
  const StepReport report = take_step(until, output_due);
  threads_.took(std::chrono::duration<double>(Timer::now() - start).count());
  return report;
}

StepReport Simulation::take_step(double until, bool output_due) {
  if (is_stage_over()) {
    begin_next_stage();
  }
  const NextStep next = next_step();
  double size = next.size;
  const double stop = stage_ < stages_.size() ? std::min(until, clock_.end) : until;
  const double end = std::min(stop, next.stop), left = end - time_;
  // A remainder below a millionth of a step is rounding, not a step of its own.
  if (left < size * (1.0 + 1e-6)) {
    size = left;
  } else if (next.even && std::isfinite(left)) {
    size = left / std::ceil(left / size * (1.0 - 1e-6));
  }
  const bool last = size == left && end == stop;
  StepReport report = advance(size, output_due || last, last);
  if (size == left && report.accepted == size) {
    time_ = end;
  }
  return report;
}

StepReport Simulation::advance(double size, bool output_due, bool last) {
  StepReport total;
  total.accepted = size;
  try {
    for (const auto& physics : physics_) {
      const StepReport report = physics->advance({time_, size, index_, output_due, last});
      total.accepted = std::min(total.accepted, report.accepted);
      total.iterations += report.iterations;
      total.residual = std::max(total.residual, report.residual);
    }
    let_points_leave();
  } catch (const StepStopped&) {
    if (physics_.size() > 1) {
      failure_ = "another physics has taken a step that was stopped";
    }
    throw;
  } catch (const StepRefused& error) {
    const std::string reason = message("step ", index_, ", time ", time_, " s: ", error.what());
    if (physics_.size() == 1) {
      throw StepRefused(reason);
    }
    failure_ = reason;
    throw RunError(reason);  // another physics has taken the step
  } catch (const RunError& error) {
    failure_ = message("step ", index_, ", time ", time_, " s: ", error.what());
    throw RunError(failure_);
  } catch (const std::bad_alloc&) {
    failure_ = message("step ", index_, ", time ", time_, " s: no memory");
    explain_no_memory("take a step");
  } catch (const std::exception& error) {
    failure_ = message("step ", index_, ", time ", time_, " s: ", error.what());
    throw;
  }
  time_ += total.accepted;
  ++index_;
  if (index_ % balance_every == 0) {
    watch_balances();
  }
  return total;
}

void Simulation::let_points_leave() {
  const std::span<const Index> leaving = points_->leaving();
  if (leaving.empty()) {
    return;
  }
  for (const auto& physics : physics_) {
    physics->release(leaving);
  }
  points_->remove_leaving();
  if (points_->size() == 0) {
    throw RunError("every point has left the grid: nothing is left to simulate");
  }
}

void Simulation::watch_balances() {
  const std::vector<Balance> now = balances();
  largest_.resize(now.size(), 0.0);
  for (std::size_t k = 0; k < now.size(); ++k) {
    largest_[k] = std::max({largest_[k], now[k].scale, now[k].turnover()});
  }
}

void Simulation::run_until(double time, const std::function<bool(const Simulation&)>& after_step) {
  require(!std::isnan(time), "run_until needs a time, got ", time);
  require(time >= time_, "cannot run back to ", time, " s: the clock is at ", time_, " s");
  while (time_ < time) {
    step(time, false);
    if (after_step && !after_step(*this)) {
      return;
    }
  }
}

std::vector<Field> Simulation::fields() {
  std::vector<Field> all;
  for (const auto& physics : physics_) {
    physics->refresh_output();
    for (Field& field : physics->fields()) {
      all.push_back(std::move(field));
    }
  }
  require_finite(all, *points_, time_);
  return all;
}

std::vector<Balance> Simulation::balances() const {
  std::vector<Balance> all;
  for (const auto& physics : physics_) {
    for (Balance& balance : physics->balances()) {
      account_.add_to(balance);
      balance.largest = all.size() < largest_.size() ? largest_[all.size()] : 0.0;
      balance.unit = extensive_unit(balance.unit, points_->dimension());
      all.push_back(std::move(balance));
    }
  }
  return all;
}

void Simulation::save(Archive& archive) const {
  archive.write("clock/time", time_);
  archive.write("clock/index", index_);
  archive.write("clock/largest_balance", std::span<const double>(largest_));
  save_state(archive);
  if (!stages_.empty()) {
    save_stage(archive);
  }
}

void Simulation::load(const Archive& archive) {
  failure_ = "a checkpoint was not read to its end";
  time_ = archive.read_number("clock/time");
  index_ = archive.read_index("clock/index");
  largest_ = archive.read_numbers("clock/largest_balance");
  if (!stages_.empty()) {
    load_stage(archive);
  }
  points_->load(archive);
  for (const auto& physics : physics_) {
    physics->load(archive);
  }
  failure_.clear();
}

}  // namespace lapilli
