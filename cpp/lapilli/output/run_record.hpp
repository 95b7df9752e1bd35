#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "lapilli/core/simulation.hpp"

namespace lapilli {

/// What a run did. Step sizes, iterations and residual count from the very start; the rest from the
/// last resume.
struct RunStatistics {
  Index steps = 0;                                                 // taken since the resume
  double smallest_step = std::numeric_limits<double>::infinity();  // s
  double largest_step = 0.0;                                       // s
  Index iterations = 0;                                            // of implicit solves
  double largest_residual = 0.0;                                   // of implicit solves, relative
  double wall_seconds = 0.0;
  double cpu_seconds = 0.0;  // of the whole process

  void count(const StepReport& report);
  void save(Archive& archive) const;
  void load(const Archive& archive);
};

/// The numbers that each physics reports, at every frame.
class History {
 public:
  void add(Simulation& simulation);
  /// Keep the first `frames`.
  void cut(Index frames);
  void save(Archive& archive) const;
  void load(const Archive& archive, Simulation& simulation);

  const std::vector<std::string>& names() const { return names_; }  // after the time
  Index frames() const { return static_cast<Index>(rows_.size() / (names_.size() + 1)); }
  /// Number `column` at `frame`; column 0 is the time.
  double at(Index frame, std::size_t column) const {
    return rows_[static_cast<std::size_t>(frame) * (names_.size() + 1) + column];
  }

 private:
  std::vector<std::string> names_;
  std::vector<double> rows_;
};

/// Everything about a run that its frames do not say.
struct RunRecord {
  std::string status;       // "running", "finished", "stopped", "failed"
  std::string message;      // why it failed
  std::string scene_text;   // TOML
  std::string settings;     // the scene with all defaults as a JSON object; may be empty
  std::string fingerprint;  // of the scene
  std::vector<std::string> not_compared;  // settings that no resume can compare: functions
  std::vector<std::string> notes;         // what the user should know: "the index was made anew"
  std::string started;                    // UTC, "2001-02-03T04:05:06Z"
  std::string frames_file;
  Index frames = 0;
  RunStatistics statistics;
  History history;
};

/// Write the record as JSON, all at once: the settings, version, compiler and threads, times and
/// speed, peak memory of the process, and of each physics its ledgers and diagnostics, these
/// at every frame too. Throws OutputError when the disk fails.
void write_run_record(const std::filesystem::path& path, const RunRecord& record,
                      const Simulation& simulation);

/// The time now as text, in UTC.
std::string utc_now();
/// Seconds of processor time this process has used, all threads together.
double cpu_seconds();
/// The most memory this process has used, bytes.
Index peak_memory();

}  // namespace lapilli
