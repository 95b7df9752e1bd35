#include "lapilli/output/run_files.hpp"

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/checksum.hpp"
#include "lapilli/output/file.hpp"
#include "lapilli/output/frame_reader.hpp"
#include "lapilli/output/owned_files.hpp"
#include "lapilli/output/verify.hpp"

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
  record_.not_compared = options.not_compared;
  record_.started = utc_now();
  record_.notes = options.notes;
  record_.volumes = options.volumes;
  record_.frames_file = options.output.filename().string();
}

/// Keep other runs off, before anything is looked at; then see to it that what is there is ours.
void RunFiles::take_over() {
  const std::filesystem::path& output = options_.output;
  check_frames_path(output);
  require_apart(files_of_run(output), options_.inputs);
  std::error_code ignored;  // making the lock says why a folder cannot be used
  std::filesystem::create_directories(output.parent_path(), ignored);
  lock_.emplace(output);
  require_replaceable_frames(output);
  for (const std::filesystem::path& checkpoint : checkpoint_paths(output)) {
    require_replaceable(checkpoint, OwnedFile::checkpoint);
  }
  require_replaceable(record_path(output), OwnedFile::record);
  require_replaceable_history(history_path(output), record_path(output));
  for (const auto& path :
       {output, checkpoint_path(output), record_path(output), history_path(output)}) {
    remove_unfinished(path);
  }
}

void RunFiles::begin() {
  require_fields(simulation_.fields(), options_.frames);
  history_.add(true);
  if (!is_writing()) {
    return;
  }
  take_over();
  // The former checkpoint first: it must never stand beside frames of another run, nor the former
  // history beside another record.
  std::error_code ignored;
  for (const std::filesystem::path& checkpoint : checkpoint_paths(options_.output)) {
    std::filesystem::remove(checkpoint, ignored);
  }
  std::filesystem::remove(history_path(options_.output), ignored);
  writer_.emplace(options_.output, schedule_.planned(), options_.frames);
  stepped_ = simulation_.time();
}

void RunFiles::write_start() {
  if (is_writing()) {
    write_frame(true);
    write_record("running", {});
    write_checkpoint({});
  }
}

/// The index is all that a reader goes by; when it is lost, the data files know the same.
void RunFiles::find_index() {
  try {
    read_index(options_.output);
  } catch (const std::exception& error) {
    const Index frames = rebuild_index(options_.output, *lock_);
    record_.notes.push_back(note("run.index-rebuilt",
                                 "the index was made anew from the data files, with ", frames,
                                 " frames: ", error.what()));
  }
}

/// The newest one that is whole. One of another scene is an error, and not passed over.
Checkpoint RunFiles::newest_checkpoint() {
  const auto paths = checkpoint_paths(options_.output);
  std::error_code ignored;
  require(std::filesystem::exists(paths[0], ignored) || std::filesystem::exists(paths[1], ignored),
          "nothing to resume: there is no checkpoint '", paths[0].string(), "'");
  std::string reason;
  for (const std::filesystem::path& path : paths) {
    std::optional<Checkpoint> checkpoint;
    try {
      checkpoint = load_checkpoint(path);
    } catch (const std::exception& error) {
      reason += (reason.empty() ? "" : "; ") + std::string(error.what());
      continue;
    }
    require_same_scene(*checkpoint, record_.fingerprint, options_.identity, path);
    if (!reason.empty()) {
      record_.notes.push_back(
          note("run.older-checkpoint", "resumed from the checkpoint before the last: ", reason));
    }
    return std::move(*checkpoint);
  }
  throw std::invalid_argument(reason);
}

void RunFiles::resume(RunStatistics& statistics) {
  take_over();
  const Checkpoint checkpoint = newest_checkpoint();
  const double time = checkpoint.state.read_number("clock/time");
  require(time <= simulation_.end(), "the checkpoint of '", options_.output.string(),
          "' is of time ", time, " s, after the end of this run at ", simulation_.end(), " s");
  find_index();
  simulation_.load(checkpoint.state);
  statistics.load(checkpoint.state);
  kept_frames_ = checkpoint.state.read_index("run/frames");
  history_.load(checkpoint.state);
  stepped_ = time;
  if (kept_frames_ > 0) {
    require_own_frames(checkpoint.state);
    require_same_form(options_.output, simulation_.points(), simulation_.fields(), options_.frames);
  }
  writer_ =
      VtkhdfWriter::resume(options_.output, kept_frames_, schedule_.planned(), options_.frames);
  write_record("running", statistics);
}

/// The checkpoint names the last frame before it by its checksum.
void RunFiles::require_own_frames(const Archive& state) const {
  if (!state.contains("run/last_frame")) {
    return;  // of a former version
  }
  FrameReader reader(options_.output);
  const Index last = kept_frames_ - 1;
  const bool fits =
      last < reader.index().frames() &&
      static_cast<Index>(reader.entry(last).sum()) == state.read_index("run/last_frame");
  require(fits, "the checkpoint of '", options_.output.string(), "' is of other frames: frame ",
          last, " is not the one it goes on from");
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
  writer_->write(simulation_.time(), simulation_.points(), simulation_.fields(),
                 simulation_.body_numbers());
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
  Checkpoint checkpoint{record_.fingerprint, {}, options_.identity};
  simulation_.save(checkpoint.state);
  statistics.save(checkpoint.state);
  checkpoint.state.write("run/frames", kept_frames_);
  if (kept_frames_ > 0) {
    checkpoint.state.write("run/last_frame", static_cast<Index>(writer_->sum_of(kept_frames_ - 1)));
  }
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

std::vector<std::filesystem::path> files_of_run(const std::filesystem::path& output) {
  const auto checkpoints = checkpoint_paths(output);
  return {output,         data_path(output, 0), record_path(output), history_path(output),
          checkpoints[0], checkpoints[1]};
}

std::filesystem::path checkpoint_path(const std::filesystem::path& output) {
  return checkpoint_paths(output)[0];
}

std::filesystem::path record_path(const std::filesystem::path& output) {
  return std::filesystem::path(output).replace_extension(".json");
}

std::filesystem::path history_path(const std::filesystem::path& output) {
  return std::filesystem::path(output).replace_extension(".csv");
}

}  // namespace lapilli
