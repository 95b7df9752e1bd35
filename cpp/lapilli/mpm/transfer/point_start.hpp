#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/materials/solid.hpp"

namespace lapilli {

/// How points start that go on from the state in which another run, or the stage before, left them.
struct PointStart {
  std::shared_ptr<const Archive> state;  // null: all points start anew
  std::vector<Index> row;       // in it, by id of the point here; -1 for points that start anew
  std::vector<int> body;        // number there, by body here; -1 for those that start anew
  std::vector<int> obstacle;    // the same of obstacles; empty: all start anew
  std::vector<int> load;        // the same of loads on surfaces
  bool same_heat_laws = false;  // whether heat conditions are those there, but for their values
  bool same_transfer = false;   // whether what points carry of the velocity means the same
  bool at_rest = false;         // whether their velocity is taken away

  double time = 0.0;                // s, of the clock
  std::vector<Solid> other_stages;  // solids of bodies in other stages of the run: what points
                                    // keep for them is kept here too

  /// Copy an array of the state to the points that go on. Throws std::invalid_argument where it is
  /// missing or of another dimension.
  void fetch(const std::string& name, const Points& points, PointArray& into) const;
};

}  // namespace lapilli
