#pragma once

#include "lapilli/core/simulation.hpp"
#include "lapilli/output/run_options.hpp"
#include "lapilli/output/run_record.hpp"

namespace lapilli {

enum class RunStatus { finished, interrupted };

struct RunSummary {
  RunStatus status = RunStatus::finished;
  double time = 0.0;  // s, simulated
  Index frames = 0;   // on disk
  RunStatistics statistics;
  std::vector<Note> notes;  // what the user should know
  History history;
};

/// Run a simulation to its end; the one run loop that the executable and Python share.
/// Frames come at the start, at k * frame_interval exactly, and at the end; a checkpoint follows
/// the frame it counts, and a run resumed from it writes the same frames as one never stopped. When
/// interrupted, the step is finished, a frame and a checkpoint are written, and the summary says
/// so; that extra frame, as one at an end off the interval, is taken away again by a resume. When a
/// step fails, fields may be half evolved: nothing more is written but the record, the last frame
/// and checkpoint on disk are the last good ones, and the error goes on to the caller. Throws
/// std::invalid_argument for options that cannot work or a checkpoint that does not fit,
/// OutputError when the disk fails, RunError when the run does.
RunSummary run(Simulation& simulation, const RunOptions& options);

}  // namespace lapilli
