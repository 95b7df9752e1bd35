#pragma once

#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/mpm/dynamics/dynamics_settings.hpp"
#include "lapilli/scene/body.hpp"
#include "lapilli/scene/tree.hpp"

namespace lapilli {

/// Values of keys of a scene by their paths, as a file writes them: "dynamics.local_damping", or
/// tables inside of tables.
struct Overrides {
  Tree::Table entries;
};

/// What follows in the same run: what changes in the scene, and when it ends.
struct Stage {
  std::string name;
  double end = 0.0;  // s, of the clock that all stages share
  std::vector<std::string> remove;
  Overrides set;
  std::vector<Body> add_bodies;
  std::vector<Obstacle> add_obstacles;
  std::vector<DynamicsBoundary> add_boundaries;
  bool reset_velocity = false;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").required().text("name in messages, balances and results"), self.name);
    visit(Key("end").unit("s").positive().required().text(
              "time at which it ends; the clock goes on from stage to stage"),
          self.end);
    visit(Key("remove").text("names of bodies, obstacles and loads that are taken away"),
          self.remove);
    visit(Key("set").text("keys of the scene, by their paths, and the values they take"), self.set);
    visit(Key("add_bodies").text("bodies that are new, at rest or as they say"), self.add_bodies);
    visit(Key("add_obstacles").text("obstacles that are new"), self.add_obstacles);
    visit(Key("add_boundaries").text("loads that are new, after those there are"),
          self.add_boundaries);
    visit(Key("reset_velocity").text("take the velocity of all bodies away at its begin"),
          self.reset_velocity);
  }
};

}  // namespace lapilli
