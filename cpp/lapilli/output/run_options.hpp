#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/body_volume.hpp"
#include "lapilli/core/note.hpp"
#include "lapilli/core/probes.hpp"
#include "lapilli/output/frame_column.hpp"

namespace lapilli {

/// How far a run has come.
struct Progress {
  double fraction = 0.0;         // of the time to simulate, 0 .. 1
  double time = 0.0;             // s, simulated
  double step_size = 0.0;        // s, of the last step
  Index step = 0;                // steps since the start
  Index points = 0;              //
  double seconds_elapsed = 0.0;  // of wall time
  double seconds_left = 0.0;     // of wall time, estimated; NaN while unknown
  Index steps_taken = 0;         // since the start or the resume
};

/// How to run a simulation and what to leave on disk. Beside the frames `run.vtkhdf` come
/// `run.checkpoint`, the record `run.json` and the history `run.csv`.
struct RunOptions {
  std::filesystem::path output;                  // ends in .vtkhdf; empty: nothing is written
  std::vector<std::filesystem::path> inputs;     // what the run is made from: never written over
  double frame_interval = 0.0;                   // s between frames; 0: the first and the last only
  Index frame_steps = 0;                         // steps between frames, instead of an interval
  FrameOptions frames;                           // what of the fields they hold, and how
  std::vector<Probe> probes;                     // columns of the history
  int bodies = std::numeric_limits<int>::max();  // those whose points the history is about
  std::vector<std::pair<double, Index>> history;  // rows beside those of frames: s or steps
  std::vector<Note> notes;                        // for the record: allowed, seldom meant
  std::vector<BodyVolume> volumes;                // for the record
  bool checkpoint = true;                         // keep a state to resume from
  double checkpoint_interval_seconds = 0.0;       // s of wall time; 0: with every frame
  bool resume = false;                            // go on from the checkpoint
  std::string scene_text;                         // TOML, for the record
  std::string settings;                           // all settings as a JSON object, for the record
  std::string fingerprint;                        // of the scene; empty: taken from scene_text
  std::string identity;  // lines "key<tab>value" that say what a resume must find the same
  std::vector<std::string> not_compared;          // settings that no resume can compare: functions
  std::function<void(const Progress&)> progress;  // at the start, ten times a second, at the end
  std::function<bool()> interrupted;              // asked after every step; true stops the run
  std::function<bool()> interrupted_in_step;      // asked within those that can be taken back
};

}  // namespace lapilli
