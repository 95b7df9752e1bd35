#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/note.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The run that a scene goes on from by `initial_state`, where its checkpoint left it.
struct LinkedRun {
  std::shared_ptr<const Archive> state;
  std::string transfer;             // of its present stage
  std::vector<std::string> bodies;  // names by the numbers of its points; empty: none
};

/// Throws std::invalid_argument for a checkpoint that cannot be used.
LinkedRun linked_run(const Scene& scene);

/// By body of the scene, the number in the other run of the one that it goes on from; -1: none.
std::vector<int> bodies_before(const Scene& scene, const LinkedRun& run);

/// Settings of bodies that go on from another run and do not start as they say, one line each;
/// nothing where the checkpoint cannot be read.
std::vector<Note> settings_left_to_run(const Scene& scene);

}  // namespace lapilli
