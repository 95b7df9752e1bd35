#pragma once

#include <string>
#include <vector>

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// One stage of a run as a scene of its own, which ends when the stage does.
struct StageScene {
  std::string name;                  // empty: the first
  Scene scene;                       // without stages
  double start = 0.0;                // s
  std::vector<int> body_before;      // by body here, its number in the stage before; -1: new
  std::vector<int> obstacle_before;  // the same of obstacles
  std::vector<int> load_before;      // and of loads
  bool same_heat_laws = true;        // as the stage before, but for their values
  std::vector<Index> body_number;    // by body here, counted over all stages
  bool same_transfer = true;         // as the stage before
  bool at_rest = false;              // bodies that go on begin without velocity
  std::vector<std::string> changes;  // in words, for reports
};

/// The stages of a scene whose files are resolved, the scene as it stands first. Throws
/// std::invalid_argument with the place in the file for a stage that cannot be: one that names what
/// there is not, ends before it begins, or changes what no stage can.
std::vector<StageScene> stage_scenes(Scene scene);

/// Names of all bodies of a run, by the numbers that users see.
std::vector<std::string> body_names(const Scene& scene);

}  // namespace lapilli
