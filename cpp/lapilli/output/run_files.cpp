#include "lapilli/output/run_files.hpp"

#include "lapilli/core/require.hpp"
#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/checksum.hpp"
#include "lapilli/output/file.hpp"

namespace lapilli {
namespace {

constexpr double record_interval_seconds = 1.0;

}  // namespace

RunFiles::RunFiles(Simulation& simulation, const RunOptions& options, const FrameSchedule& schedule)
    : simulation_(simulation),
      options_(options),
      schedule_(schedule),
      history_(simulation, options) {
  record_.scene_text = options.scene_text;
  record_.settings = options.settings;
  record_.fingerprint =
      options.fingerprint.empty() ? fingerprint(options.scene_text) : options.fingerprint;
  record_.started = utc_now();
  record_.notes = options.notes;
  record_.frames_file = options.output.filename().string();
}

void RunFiles::begin() {
  history_.add(true);
  if (!is_writing()) {
    return;
  }
  // The former checkpoint first: it must never stand beside frames of another run.
  check_frames_path(options_.output);
  std::error_code ignored;
  std::filesystem::remove(checkpoint_path(options_.output), ignored);
  writer_.emplace(options_.output, schedule_.planned());
  stepped_ = simulation_.time();
  write_frame(true);
  write_record("running", {});
  write_checkpoint({});
}

void RunFiles::resume(RunStatistics& statistics) {
  const std::filesystem::path path = checkpoint_path(options_.output);
  require(std::filesystem::exists(path), "nothing to resume: there is no checkpoint '",
          path.string(), "'");
  const Checkpoint checkpoint = load_checkpoint(path);
  require_same_scene(checkpoint, record_.fingerprint, path);
  const double time = checkpoint.state.read_number("clock/time");
  require(time <= simulation_.end(), "the checkpoint '", path.string(), "' is of time ", time,
          " s, after the end of this run at ", simulation_.end(), " s");
  simulation_.load(checkpoint.state);
  statistics.load(checkpoint.state);
  kept_frames_ = checkpoint.state.read_index("run/frames");
  history_.load(checkpoint.state);
  stepped_ = time;
  writer_ = VtkhdfWriter::resume(options_.output, kept_frames_, schedule_.planned());
  write_record("running", statistics);
}

void RunFiles::after_step(const RunStatistics& statistics) {
  history_.after_step();
  const double time = simulation_.time();
  const bool due =
      schedule_.is_due(time, simulation_.step_index()) || schedule_.is_passed(stepped_, time);
  stepped_ = time;
  if (due) {
    history_.add(true);
  }
  if (!is_writing()) {
    return;
  }
  if (due) {
    write_frame(true);
    keep_record(statistics);
  }
  const double interval = options_.checkpoint_interval_seconds;
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - checkpointed_;
  if (interval > 0.0 ? since.count() >= interval : due) {
    write_checkpoint(statistics);
  }
}

void RunFiles::stop(const RunStatistics& statistics) {
  history_.add(false);
  if (!is_writing()) {
    return;
  }
  if (!has_frame_of_now()) {
    write_frame(false);
  }
  write_checkpoint(statistics);
}

void RunFiles::write_frame(bool keep) {
  writer_->write(simulation_.time(), simulation_.points(), simulation_.fields());
  if (keep) {
    kept_frames_ = writer_->frames();
  }
}

void RunFiles::keep_record(const RunStatistics& statistics) {
  // The record grows with every frame: not so often that writing it counts.
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - recorded_;
  if (since.count() >= record_interval_seconds) {
    write_record("running", statistics);
    recorded_ = std::chrono::steady_clock::now();
  }
}

void RunFiles::write_checkpoint(const RunStatistics& statistics) {
  if (!options_.checkpoint) {
    return;
  }
  Checkpoint checkpoint{record_.fingerprint, {}};
  simulation_.save(checkpoint.state);
  statistics.save(checkpoint.state);
  checkpoint.state.write("run/frames", kept_frames_);
  history_.save(checkpoint.state);
  save_checkpoint(checkpoint_path(options_.output), checkpoint);
  checkpointed_ = std::chrono::steady_clock::now();
}

void RunFiles::write_record(const char* status, const RunStatistics& statistics,
                            const std::string& message) {
  if (!is_writing()) {
    return;
  }
  record_.status = status;
  record_.message = message;
  record_.statistics = statistics;
  record_.frames = frames();
  write_run_record(record_path(options_.output), record_, history(), simulation_);
  write_text(history_path(options_.output), history().to_csv());
}

std::string RunFiles::last_frame() const {
  return frames() == 0 ? ""
                       : message("; the last good frame is that of time ", writer_->times().back(),
                                 " s in '", options_.output.string(), "'");
}

std::filesystem::path checkpoint_path(const std::filesystem::path& output) {
  return std::filesystem::path(output).replace_extension(".checkpoint");
}

std::filesystem::path record_path(const std::filesystem::path& output) {
  return std::filesystem::path(output).replace_extension(".json");
}

std::filesystem::path history_path(const std::filesystem::path& output) {
  return std::filesystem::path(output).replace_extension(".csv");
}

}  // namespace lapilli
