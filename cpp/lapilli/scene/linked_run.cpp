#include "lapilli/scene/linked_run.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/tree_writer.hpp"

namespace lapilli {
namespace {

using Settings = std::map<std::string, std::string>;

/// The settings that a checkpoint tells of its scene.
Settings settings_in(const std::string& identity) {
  Settings settings;
  std::istringstream lines(identity);
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t tab = line.find('\t'); tab != std::string::npos) {
      settings[line.substr(0, tab)] = line.substr(tab + 1);
    }
  }
  return settings;
}

/// Names of the bodies of one list.
void add_names(const Settings& settings, const std::string& list, std::vector<std::string>& names) {
  for (int number = 0;; ++number) {
    const auto name = settings.find(message(list, ".", number, ".name"));
    if (name == settings.end()) {
      return;
    }
    names.push_back(name->second);
  }
}

bool has_stages(const Settings& settings) { return settings.contains("stages.0.name"); }

/// Of the bodies of all stages, as users number them.
std::vector<std::string> names_of_all(const Settings& settings) {
  std::vector<std::string> names;
  add_names(settings, "bodies", names);
  for (int stage = 0; settings.contains(message("stages.", stage, ".name")); ++stage) {
    add_names(settings, message("stages.", stage, ".add_bodies"), names);
  }
  return names;
}

/// Of those that the present stage has: the points count these.
std::vector<std::string> names_of_present(const Archive& state, const Settings& settings) {
  std::vector<std::string> all = names_of_all(settings);
  const std::vector<Index> present =
      state.contains("stage/bodies") ? state.read_indices("stage/bodies") : std::vector<Index>();
  if (present.empty()) {
    return all;
  }
  std::vector<std::string> names;
  for (const Index number : present) {
    const auto known = static_cast<std::size_t>(number);
    names.push_back(known < all.size() ? all[known] : std::string());
  }
  return names;
}

std::string transfer_in(const Archive& state, const Settings& settings) {
  if (state.contains("dynamics/transfer")) {
    return state.read_text("dynamics/transfer");
  }
  const auto transfer = settings.find("dynamics.transfer");
  return transfer == settings.end() ? "" : transfer->second;
}

/// What the start of a body is made from, temperature aside.
bool is_of_start(const std::string& key) {
  constexpr const char* keys[] = {"velocity",        "spin",          "spin_center", "translation",
                                  "rotation",        "rotation_axis", "geostatic",   "jitter",
                                  "rotation_center", "random",        "seed",        "fill",
                                  "points_per_cell"};
  return std::ranges::find(keys, key) != std::end(keys);
}

bool has_temperatures(const Archive& state) {
  return std::ranges::any_of(state.arrays(),
                             [](const auto& array) { return array.first.starts_with("heat/"); });
}

std::vector<Note> left_to(const LinkedRun& run, const Scene& scene) {
  std::vector<Note> notes;
  const bool with_heat = scene.heat && has_temperatures(*run.state);
  const std::vector<int> before = bodies_before(scene, run);
  const TreeWriter writer(Members::changed, InMemory::named);
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (before[k] < 0) {
      continue;
    }
    const Tree body = {writer.write_struct(scene.bodies[k], ""), {}};
    for (const Tree::Entry& entry : *body.table()) {
      if (is_of_start(entry.name) || (with_heat && entry.name == "temperature")) {
        notes.push_back(note("scene.no-effect", element_path("bodies", k), ".", entry.name,
                             " has no effect: the body goes on from initial_state"));
      }
    }
  }
  return notes;
}

}  // namespace

LinkedRun linked_run(const Scene& scene) {
  const std::string& name = scene.initial_state;
  require_at(!name.ends_with(".vtkhdf"), scene, "initial_state",
             "names frames; the state is in the checkpoint beside them: ",
             name.substr(0, name.size() - std::string(".vtkhdf").size()), ".checkpoint");
  Checkpoint checkpoint =
      in_file(scene, "initial_state", [&] { return load_checkpoint(scene.initial_state); });
  LinkedRun run;
  run.state = std::make_shared<const Archive>(std::move(checkpoint.state));
  const Settings settings = settings_in(checkpoint.identity);
  require_at(!has_stages(settings) || run.state->contains("stage/bodies"), scene, "initial_state",
             "is of a run in stages by an earlier version, which does not tell the bodies that "
             "are left: run it again");
  run.transfer = transfer_in(*run.state, settings);
  run.bodies = names_of_present(*run.state, settings);
  return run;
}

std::vector<int> bodies_before(const Scene& scene, const LinkedRun& run) {
  std::vector<int> before;
  for (const Body& body : scene.bodies) {
    const auto found = std::ranges::find(run.bodies, body.name);
    const bool is_known = !body.name.empty() && found != run.bodies.end();
    before.push_back(is_known ? static_cast<int>(found - run.bodies.begin()) : -1);
  }
  return before;
}

std::vector<Note> settings_left_to_run(const Scene& scene) {
  if (scene.initial_state.empty()) {
    return {};
  }
  try {
    return left_to(linked_run(with_resolved_files(scene)), scene);
  } catch (const std::invalid_argument&) {
    return {};  // who builds the scene says so
  } catch (const OutputError&) {
    return {};
  }
}

}  // namespace lapilli
