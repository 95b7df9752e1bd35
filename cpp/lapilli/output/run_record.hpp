#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "lapilli/core/body_volume.hpp"
#include "lapilli/core/note.hpp"
#include "lapilli/core/simulation.hpp"
#include "lapilli/output/history.hpp"

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

/// Everything about a run that its frames do not say.
struct RunRecord {
  std::string status;       // "running", "finished", "stopped", "failed"
  std::string message;      // why it failed
  std::string scene_text;   // TOML
  std::string settings;     // the scene with all defaults as a JSON object; may be empty
  std::string fingerprint;  // of the scene
  std::vector<std::string> not_compared;  // settings that no resume can compare: functions
  std::vector<Note> notes;                // what the user should know: "the index was made anew"
  std::string started;                    // UTC, "2001-02-03T04:05:06Z"
  std::string frames_file;
  Index frames = 0;
  std::vector<BodyVolume> volumes;
  RunStatistics statistics;
};

/// Write the record as JSON, all at once: the settings, version, compiler and threads, times and
/// speed, peak memory of the process, of each physics its balances and diagnostics, and the history
/// of scalars. Throws OutputError when the disk fails.
void write_run_record(const std::filesystem::path& path, const RunRecord& record,
                      const History& history, const Simulation& simulation);

/// The time now as text, in UTC.
std::string utc_now();
/// Seconds of processor time this process has used, all threads together.
double cpu_seconds();
/// The most memory this process has used, bytes.
Index peak_memory();

}  // namespace lapilli
