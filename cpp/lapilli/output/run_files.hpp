#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "lapilli/core/simulation.hpp"
#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/frame_schedule.hpp"
#include "lapilli/output/run_lock.hpp"
#include "lapilli/output/run_options.hpp"
#include "lapilli/output/run_record.hpp"
#include "lapilli/output/vtkhdf_writer.hpp"

namespace lapilli {

/// The files of one run: frames, checkpoint, record, history, and the lock that keeps other runs
/// off them while it lives. Without an output path it writes nothing and keeps the history alone.
class RunFiles {
 public:
  /// Options and schedule must outlive it.
  RunFiles(Simulation& simulation, const RunOptions& options, const FrameSchedule& schedule);

  /// Take the output over and start new files.
  void begin();
  /// Put the state of now into new files.
  void write_start();
  /// Bring simulation, statistics and frames back to the checkpoint.
  void resume(RunStatistics& statistics);
  /// Write what is due after a step.
  void after_step(const RunStatistics& statistics);
  /// Write the state at which the run stops, whether or not it was due.
  void stop(const RunStatistics& statistics);
  void write_record(const char* status, const RunStatistics& statistics,
                    const std::string& message = "");

  /// What the user should know.
  const std::vector<Note>& notes() const { return record_.notes; }
  const History& history() const { return history_.history(); }
  bool is_writing() const { return !options_.output.empty(); }
  Index frames() const { return writer_ ? writer_->frames() : 0; }
  /// Where the last frame is, as the end of a message; empty when there is none.
  std::string last_frame() const;

 private:
  bool has_frame_of_now() const {
    return writer_->frames() > 0 && writer_->times().back() == simulation_.time();
  }
  void take_over();
  void find_index();
  Checkpoint newest_checkpoint();
  void require_own_frames(const Archive& state) const;
  void write_frame(bool keep);
  void keep_record(const RunStatistics& statistics);
  void write_checkpoint(const RunStatistics& statistics);

  Simulation& simulation_;
  const RunOptions& options_;
  const FrameSchedule& schedule_;
  std::optional<RunLock> lock_;
  RunRecord record_;
  HistoryRecorder history_;
  std::optional<VtkhdfWriter> writer_;
  Index kept_frames_ = 0;  // those that a resumed run does not write again
  double stepped_ = 0.0;   // s, of the last step seen
  std::chrono::steady_clock::time_point checkpointed_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point recorded_;
};

/// Files beside the frames: run.vtkhdf -> run.checkpoint, run.json, run.csv.
std::filesystem::path checkpoint_path(const std::filesystem::path& output);
std::filesystem::path record_path(const std::filesystem::path& output);
std::filesystem::path history_path(const std::filesystem::path& output);
/// All files that a run of this output writes.
std::vector<std::filesystem::path> files_of_run(const std::filesystem::path& output);

}  // namespace lapilli
