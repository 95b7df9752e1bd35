#include "lapilli/scene/audit.hpp"

#include <algorithm>
#include <iterator>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/idle_rules.hpp"
#include "lapilli/scene/linked_run.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/stage_scenes.hpp"
#include "lapilli/scene/tree_writer.hpp"

namespace lapilli {
namespace {

/// "bodies[2].seed" as "bodies[].seed", and its first index.
std::pair<std::string, std::size_t> pattern_of(const std::string& path) {
  const std::size_t open = path.find('['), close = path.find(']');
  if (open == std::string::npos) {
    return {path, 0};
  }
  return {path.substr(0, open + 1) + path.substr(close),
          std::stoul(path.substr(open + 1, close - open - 1))};
}

void check_path(const Scene& scene, const std::string& path, std::vector<Note>& notes) {
  const auto [pattern, index] = pattern_of(path);
  for (const IdleRule& rule : idle_rules()) {
    if (pattern == rule.pattern && rule.is_idle(scene, index)) {
      notes.push_back(note("scene.no-effect", path, " has no effect: ", rule.why));
    }
  }
}

// Every setting that was changed, down to the members of elements of lists.
void visit_changed(const Scene& scene, const Tree& tree, const std::string& path,
                   std::vector<Note>& notes) {
  check_path(scene, path, notes);
  if (const Tree::Table* table = tree.table()) {
    for (const Tree::Entry& entry : *table) {
      visit_changed(scene, entry.value, joined_path(path, entry.name), notes);
    }
  } else if (const Tree::Array* array = tree.array()) {
    for (std::size_t k = 0; k < array->size(); ++k) {
      if ((*array)[k].table()) {
        visit_changed(scene, (*array)[k], element_path(path, k), notes);
      }
    }
  }
}

/// Why no physics of the scene reads a material; empty when one does.
struct IdleMaterial {
  const Scene& scene;

  std::string operator()(const Thermal&) const {
    return without_heat(scene) ? "the scene has no heat" : "";
  }
  std::string operator()(const Newtonian&) const {
    return scene.peridynamics && scene.peridynamics->flow ? "" : "there is no [peridynamics.flow]";
  }
  std::string operator()(const HasElasticPart auto&) const {
    return scene.dynamics || scene.quasi_static ? "" : "nothing deforms in this scene";
  }
  template <class Coupling>
  std::string operator()(const Coupling&) const {
    return "";  // validate() asks for both of its physics
  }
};

}  // namespace

namespace {

std::vector<Note> unused_in_one_stage(const Scene& scene) {
  std::vector<Note> notes;
  const TreeWriter writer(Members::changed, InMemory::named);
  visit_changed(scene, {writer.write_struct(scene, ""), {}}, "", notes);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    for (const Material& material : scene.bodies[k].material) {
      const std::string why = std::visit(IdleMaterial{scene}, material);
      if (!why.empty()) {
        const char* kind = std::visit([](const auto& known) { return known.kind; }, material);
        notes.push_back(note("scene.no-effect", element_path("bodies", k), ".material: ", kind,
                             " has no effect: ", why));
      }
    }
  }
  return notes;
}

}  // namespace

std::vector<Note> unused_settings(const Scene& scene) {
  std::vector<Note> notes = unused_in_one_stage(scene);
  std::ranges::copy(settings_left_to_run(scene), std::back_inserter(notes));
  if (scene.stages.empty()) {
    return notes;
  }
  const std::size_t of_first = notes.size();
  for (const StageScene& stage : stage_scenes(with_resolved_files(scene))) {
    for (const Note& one : unused_in_one_stage(stage.scene)) {
      const auto end = notes.begin() + static_cast<std::ptrdiff_t>(of_first);
      if (!stage.name.empty() && std::find(notes.begin(), end, one) == end) {
        notes.push_back(note(one.code, "stage ", stage.name, ": ", one.text));
      }
    }
  }
  return notes;
}

}  // namespace lapilli
