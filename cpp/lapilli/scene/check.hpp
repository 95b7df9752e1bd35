#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// What is known of a scene before it runs.
struct CheckReport {
  struct BodyReport {
    std::string name;
    Index points = 0;
    double volume = 0.0;                    // m^dimension, of the points
    double spacing = 0.0;                   // m
    std::optional<double> volume_of_shape;  // m^dimension; none without a shape
  };
  /// A stage after the first, made from the state at the start: the nearest that is known.
  struct StageReport {
    std::string name;
    double start = 0.0, end = 0.0;  // s
    Index points = 0;
    double step = 0.0;                 // s
    Index steps = 0;                   // 0: not known
    std::vector<std::string> changes;  // in words
  };

  std::string title;
  int dimension = 0;
  std::vector<Index> cells;  // along each axis
  Index nodes = 0;
  std::vector<BodyReport> bodies;
  Index points = 0;
  std::vector<std::string> modelled;
  std::vector<std::string> not_modelled;
  double step = 0.0;        // s
  double hard_limit = 0.0;  // s; infinite when nothing limits the step
  std::string step_reason;
  Index steps = 0;  // of the first stage
  std::vector<StageReport> stages;
  double memory = 0.0;            // bytes, estimated from the sizes of arrays
  double output = 0.0;            // bytes on disk, estimated
  double seconds_to_build = 0.0;  // measured
  double seconds_to_run = 0.0;    // extrapolated from the first steps
  std::vector<Note> notes;        // settings that are allowed and seldom meant

  template <class... Parts>
  void say(NoteCode code, const Parts&... parts) {
    notes.push_back({code, message(parts...)});
  }
};

/// Build the scene, run its first few steps and say what it is; a large one is described by its
/// bounds, without building it. Throws std::invalid_argument as build() does.
CheckReport check(const Scene& scene);

/// The report as lines of text.
std::string text_of(const CheckReport& report);

/// The report as JSON.
std::string json_of(const CheckReport& report);

}  // namespace lapilli
