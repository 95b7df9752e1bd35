// Which keys a stage may set, and how it does.
#include <algorithm>

#include "lapilli/scene/emit.hpp"
#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "lapilli/scene/stage_changes.hpp"

namespace lapilli {
namespace {

/// One key with its value, and where it stands.
struct Assignment {
  std::vector<std::string> path;
  Tree value;
  Place place;
};

/// A table that is one value, not a table of keys: a shape or a law, a table in time.
bool is_value(const Tree::Table& table) {
  return find(table, "kind") || find(table, "times") || find(table, "temperatures") ||
         find(table, "file");
}

void forget_places(Tree& tree) {
  tree.place = {};
  if (auto* array = std::get_if<Tree::Array>(&tree.value)) {
    std::ranges::for_each(*array, forget_places);
  } else if (auto* table = std::get_if<Tree::Table>(&tree.value)) {
    for (Tree::Entry& entry : *table) {
      entry.place = {};
      forget_places(entry.value);
    }
  }
}

/// Tables of keys set the keys they hold; what they do not name stays.
void gather(const Tree::Table& table, const std::vector<std::string>& above,
            std::vector<Assignment>& all) {
  for (const Tree::Entry& entry : table) {
    std::vector<std::string> path = above;
    const std::vector<std::string> names = path_names(entry.name);
    path.insert(path.end(), names.begin(), names.end());
    if (const Tree::Table* inner = entry.value.table(); inner && !is_value(*inner)) {
      gather(*inner, path, all);
      continue;
    }
    all.push_back({std::move(path), entry.value, entry.place});
    forget_places(all.back().value);
  }
}

std::string spelled(const std::vector<std::string>& path) {
  std::string text;
  for (const std::string& name : path) {
    text = joined_path(text, name);
  }
  return text;
}

/// Why no stage can set this key; empty where one can.
std::string why_not(const std::vector<std::string>& path) {
  const std::string& first = path.front();
  const std::string last = path.back();
  if (first == "bodies") {
    const bool of_material = path.size() > 2 && path[2] == "material";
    if (!of_material && !(path.size() > 2 && path[2] == "source")) {
      return "bodies go on as they are: a stage sets what they are made of, and their source";
    }
    return last == "density" ? "bodies that go on keep their mass" : "";
  }
  if (first == "time") {
    return last == "step" || last == "steps" ? "" : "the end of a stage is its own key `end`";
  }
  if (first == "grid" || first == "heat") {
    return path.size() > 1 ? "" : "name the key of it that changes";
  }
  if (first == "dynamics") {
    const bool list = path.size() == 2 && (last == "obstacles" || last == "contacts");
    return last == "obstacles" && list ? "stages remove and add obstacles by name"
           : path.size() > 1           ? ""
                                       : "name the key of it that changes";
  }
  return "stages set keys of grid, bodies, dynamics, heat and time";
}

}  // namespace

void set_keys(const Scene& scene, std::size_t k, StageScene& stage) {
  std::vector<Assignment> all;
  gather(scene.stages[k].set.entries, {}, all);
  const std::string path = element_path("stages", k) + ".set";
  for (const Assignment& one : all) {
    const std::string where =
        scene.places && one.place.line > 0
            ? message(scene.places->source, ":", one.place.line, ":", one.place.column, ": ")
            : place_text(scene.places.get(), path);
    const std::string why = why_not(one.path);
    require(why.empty(), where, path, ": ", spelled(one.path), " cannot be set: ", why);
    const bool was_absent = !stage.scene.heat && one.path.front() == "heat";
    require(!was_absent, where, path, ": ", spelled(one.path),
            " cannot be set: the scene has no [heat], and stages add no physics");
    try {
      set_member(stage.scene, one.path, one.value, "");
      if (one.path.front() == "time") {
        TimeSettings& time = stage.scene.time;
        one.path.back() == "step" ? time.steps.reset() : time.step.reset();
      }
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(message(where, path, ": ", error.what()));
    }
    if (one.path == std::vector<std::string>{"dynamics", "boundaries"}) {
      stage.load_before.assign(stage.scene.dynamics->boundaries.size(), -1);
    }
    if (one.path == std::vector<std::string>{"heat", "boundaries"}) {
      stage.same_heat_laws = false;
    }
    const std::string value = emit_toml({Tree::Table{{"x", {}, one.value}}, {}});
    stage.changes.push_back(one.value.table() || one.value.array()
                                ? spelled(one.path) + " changes"
                                : spelled(one.path) + value.substr(1, value.size() - 2));
  }
}

}  // namespace lapilli
