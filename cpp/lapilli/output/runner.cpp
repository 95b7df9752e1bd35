#include "lapilli/output/runner.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/core/seconds_since.hpp"
#include "lapilli/core/step_refused.hpp"
#include "lapilli/core/step_stop.hpp"
#include "lapilli/core/whole_steps.hpp"
#include "lapilli/output/frame_schedule.hpp"
#include "lapilli/output/run_files.hpp"

namespace lapilli {
namespace {

using Clock = std::chrono::steady_clock;

/// Tells the caller how far the run is, at most ten times a second.
class ProgressReport {
 public:
  ProgressReport(const Simulation& simulation, const std::function<void(const Progress&)>& tell)
      : simulation_(simulation),
        tell_(tell),
        first_fraction_(fraction()),
        first_step_(simulation.step_index()) {}

  void tell(double step_size, bool always) {
    if (!tell_ || (!always && seconds_since(told_) < 0.1)) {
      return;
    }
    told_ = Clock::now();
    const double elapsed = seconds_since(begin_), done = fraction();
    const double left = elapsed * (1.0 - done) / (done - first_fraction_);
    tell_({done, simulation_.time(), step_size, simulation_.step_index(),
           simulation_.points().size(), elapsed, done > first_fraction_ ? left : std::nan(""),
           simulation_.step_index() - first_step_});
  }

 private:
  double fraction() const {
    return simulation_.end() > 0.0 ? simulation_.time() / simulation_.end() : 1.0;
  }

  const Simulation& simulation_;
  const std::function<void(const Progress&)>& tell_;
  double first_fraction_;
  Index first_step_;
  Clock::time_point begin_ = Clock::now(), told_ = begin_;
};

/// Statistics of the run with the clocks read now.
class Measure {
 public:
  RunStatistics& now() {
    statistics_.wall_seconds = seconds_since(wall_);
    statistics_.cpu_seconds = cpu_seconds() - cpu_;
    return statistics_;
  }

 private:
  RunStatistics statistics_;
  Clock::time_point wall_ = Clock::now();
  double cpu_ = cpu_seconds();
};

/// Where the next step may end at the latest: at the next frame, or where the physics keeps its
/// steps whole at the first frame after the step.
double end_of_step(const Simulation& simulation, const FrameSchedule& schedule) {
  double until = schedule.next_time(simulation.time());
  const auto& all = simulation.physics();
  if (std::any_of(all.begin(), all.end(), [](const auto& physics) {
        return dynamic_cast<const WholeSteps*>(physics.get()) != nullptr;
      })) {
    const double whole = simulation.next_step_size() * (1.0 - 1e-6);
    while (until < simulation.end() && until - simulation.time() < whole) {
      until = schedule.next_time(until);
    }
  }
  return until;
}

/// False where the step was stopped on its way, which then is as not begun.
bool take_step(Simulation& simulation, const FrameSchedule& schedule, StepReport& report) {
  try {
    report = simulation.step(end_of_step(simulation, schedule), false);
    return true;
  } catch (const StepStopped&) {
    return false;
  }
}

RunStatus step_to_end(Simulation& simulation, const RunOptions& options,
                      const FrameSchedule& schedule, RunFiles& files, RunStatistics& statistics) {
  ProgressReport progress(simulation, options.progress);
  const StepStop stop(options.interrupted_in_step);
  double size = 0.0;
  progress.tell(size, true);
  RunStatus status = RunStatus::finished;
  while (simulation.time() < simulation.end()) {
    StepReport report;
    if (!take_step(simulation, schedule, report)) {
      status = RunStatus::interrupted;
      break;
    }
    size = report.accepted;
    statistics.count(report);
    files.after_step(statistics);
    if (options.interrupted && options.interrupted()) {
      status = RunStatus::interrupted;
      break;
    }
    progress.tell(size, false);
  }
  files.stop(statistics);
  progress.tell(size, true);
  return status;
}

void require_closed_balances(const Simulation& simulation) {
  const std::string wrong = open_balances(simulation.balances());
  if (!wrong.empty()) {
    throw RunError("at the end: " + wrong);
  }
}

/// Record a failure; a disk that fails here too must not hide the reason of the first failure.
void record_failure(RunFiles& files, const RunStatistics& statistics, const std::string& reason) {
  try {
    files.write_record("failed", statistics, reason);
  } catch (const std::exception&) {
  }
}

}  // namespace

RunSummary run(Simulation& simulation, const RunOptions& options) {
  const FrameSchedule schedule(options.frame_interval, options.frame_steps, simulation.end(),
                               simulation.stage_ends());
  RunFiles files(simulation, options, schedule);
  require(files.is_writing() || !options.resume, "to resume a run give the output it wrote");
  Measure measure;
  if (options.resume) {
    files.resume(measure.now());
  } else {
    files.begin();
  }
  try {
    if (!options.resume) {
      files.write_start();
    }
    const RunStatus status = step_to_end(simulation, options, schedule, files, measure.now());
    if (status == RunStatus::finished) {
      require_closed_balances(simulation);
    }
    files.write_record(status == RunStatus::finished ? "finished" : "stopped", measure.now());
    return {status,        simulation.time(), files.frames(),
            measure.now(), files.notes(),     files.history()};
  } catch (const StepRefused& error) {
    files.stop(measure.now());
    const std::string reason = error.what() + files.last_frame();
    record_failure(files, measure.now(), reason);
    throw RunError(reason);
  } catch (const RunError& error) {
    const std::string reason = error.what() + files.last_frame();
    record_failure(files, measure.now(), reason);
    throw RunError(reason);
  } catch (const std::exception& error) {
    record_failure(files, measure.now(), error.what());
    throw;
  }
}

}  // namespace lapilli
