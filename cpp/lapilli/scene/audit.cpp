#include "lapilli/scene/audit.hpp"

#include <algorithm>

#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/stage_scenes.hpp"
#include "lapilli/scene/tree_writer.hpp"

namespace lapilli {
namespace {

/// A setting, the scenes that do not read it, and why. `[]` stands for any index, whose value is
/// handed on.
struct Rule {
  const char* pattern;
  bool (*is_idle)(const Scene& scene, std::size_t index);
  const char* why;
};

bool without_heat(const Scene& scene) {
  return !scene.heat && !(scene.peridynamics && scene.peridynamics->heat);
}
bool points_move(const Scene& scene) {
  return scene.dynamics || std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                       [](const Body& body) { return body.motion.has_value(); });
}
template <class... Kind>
bool has_boundary(const Scene& scene) {
  return scene.heat && std::any_of(scene.heat->boundaries.begin(), scene.heat->boundaries.end(),
                                   [](const HeatBoundary& one) {
                                     return (std::holds_alternative<Kind>(one) || ...);
                                   });
}
bool without_normals(const Scene& scene) {
  return scene.heat->method == FluxMethod::node || scene.heat->method == FluxMethod::paper;
}
bool without_adaptive_steps(const Scene& scene) {
  return scene.heat->time_integration != TimeIntegration::automatic || scene.time.step ||
         scene.time.steps;
}

bool without_supports(const Scene& scene) { return scene.quasi_static->supports.empty(); }
const PeridynamicFlowSettings& flow_of(const Scene& scene) { return *scene.peridynamics->flow; }

constexpr Rule rules[] = {
    {"grid.shape_function",
     [](const Scene& scene, std::size_t) { return scene.peridynamics.has_value(); },
     "peridynamics uses no shape functions"},
    {"bodies[].temperature", [](const Scene& scene, std::size_t) { return without_heat(scene); },
     "the scene has no heat"},
    {"bodies[].source", [](const Scene& scene, std::size_t) { return without_heat(scene); },
     "the scene has no heat"},
    {"bodies[].velocity",
     [](const Scene& scene, std::size_t) {
       return scene.peridynamics && !scene.peridynamics->flow;
     },
     "nothing moves without [peridynamics.flow]"},
    {"bodies[].seed",
     [](const Scene& scene, std::size_t k) {
       return scene.bodies[k].jitter == 0.0 && !scene.bodies[k].random;
     },
     "there is neither jitter nor random"},
    {"bodies[].rotation_center",
     [](const Scene& scene, std::size_t k) { return scene.bodies[k].rotation == 0.0; },
     "the body is not rotated"},
    {"bodies[].rotation_axis",
     [](const Scene& scene, std::size_t k) {
       return scene.bodies[k].rotation == 0.0 || dimension_of(scene) < 3;
     },
     "no body is rotated about an axis here"},
    {"bodies[].points_per_cell",
     [](const Scene& scene, std::size_t k) { return !scene.bodies[k].shape; },
     "the points are given"},
    {"bodies[].jitter", [](const Scene& scene, std::size_t k) { return !scene.bodies[k].shape; },
     "the points are given"},
    {"bodies[].random", [](const Scene& scene, std::size_t k) { return !scene.bodies[k].shape; },
     "the points are given"},
    {"heat.method",
     [](const Scene& scene, std::size_t) {
       return !has_boundary<Flux, Convection, Radiation>(scene);
     },
     "no boundary condition prescribes a flux"},
    {"heat.theta",
     [](const Scene& scene, std::size_t) {
       return scene.heat->time_integration != TimeIntegration::implicit_theta;
     },
     "heat.time_integration is not implicit"},
    {"heat.solver",
     [](const Scene& scene, std::size_t) {
       return scene.heat->time_integration != TimeIntegration::implicit_theta &&
              without_adaptive_steps(scene);
     },
     "heat.time_integration is explicit, or the step is given"},
    {"heat.tolerance",
     [](const Scene& scene, std::size_t) { return without_adaptive_steps(scene); },
     "heat.time_integration is not auto, or the step is given"},
    {"heat.blend",
     [](const Scene& scene, std::size_t) {
       const HeatTransfer transfer = scene.heat->transfer;
       return !(transfer == HeatTransfer::affine ||
                (transfer == HeatTransfer::automatic && points_move(scene)));
     },
     "only heat.transfer = affine blends"},
    {"heat.surface_fraction",
     [](const Scene& scene, std::size_t) { return scene.heat->method != FluxMethod::paper; },
     "heat.method is not paper"},
    {"heat.normal_smoothing",
     [](const Scene& scene, std::size_t) { return without_normals(scene); },
     "heat.method smooths no normals"},
    {"heat.corner_fit", [](const Scene& scene, std::size_t) { return without_normals(scene); },
     "heat.method fits no corners"},
    {"heat.implicit_robin",
     [](const Scene& scene, std::size_t) { return !has_boundary<Convection, Radiation>(scene); },
     "there is neither convection nor radiation"},
    {"heat.subcycling", [](const Scene& scene, std::size_t) { return !scene.dynamics; },
     "without [dynamics] every step is one of heat"},
    {"dynamics.pic_fraction",
     [](const Scene& scene, std::size_t) {
       return scene.dynamics->transfer != VelocityTransfer::flip;
     },
     "dynamics.transfer is not flip"},
    {"dynamics.courant",
     [](const Scene& scene, std::size_t) { return scene.time.step || scene.time.steps; },
     "time gives the step"},
    {"quasi_static.enforcement",
     [](const Scene& scene, std::size_t) { return without_supports(scene); }, "there are no walls"},
    {"quasi_static.bandwidth",
     [](const Scene& scene, std::size_t) {
       return without_supports(scene) || scene.quasi_static->enforcement == Enforcement::nitsche;
     },
     "no wall has a stiff constraint"},
    {"quasi_static.gap_bandwidth",
     [](const Scene& scene, std::size_t) {
       return without_supports(scene) ||
              (scene.quasi_static->enforcement != Enforcement::mean_gap &&
               scene.quasi_static->enforcement != Enforcement::nitsche);
     },
     "no wall has a moderate constraint"},
    {"quasi_static.hold_empty_cells",
     [](const Scene& scene, std::size_t) { return without_supports(scene); }, "there are no walls"},
    {"quasi_static.max_penetration",
     [](const Scene& scene, std::size_t) { return without_supports(scene); }, "there are no walls"},
    {"peridynamics.heat.dissipation",
     [](const Scene& scene, std::size_t) { return !scene.peridynamics->flow; },
     "nothing flows without [peridynamics.flow]"},
    {"peridynamics.heat.zero_energy",
     [](const Scene& scene, std::size_t) {
       return scene.peridynamics->heat->laplacian != Laplacian::zero_energy;
     },
     "its laplacian is not zero-energy"},
    {"peridynamics.flow.sound_speed_factor",
     [](const Scene& scene, std::size_t) { return flow_of(scene).sound_speed > 0.0; },
     "sound_speed is given"},
    {"peridynamics.flow.length",
     [](const Scene& scene, std::size_t) { return flow_of(scene).sound_speed > 0.0; },
     "sound_speed is given"},
    {"peridynamics.flow.temperature_range",
     [](const Scene& scene, std::size_t) { return flow_of(scene).sound_speed > 0.0; },
     "sound_speed is given"},
    {"output.checkpoint_every",
     [](const Scene& scene, std::size_t) { return !scene.output.checkpoint; },
     "output.checkpoint is off"},
};

/// "bodies[2].seed" as "bodies[].seed", and its first index.
std::pair<std::string, std::size_t> pattern_of(const std::string& path) {
  const std::size_t open = path.find('['), close = path.find(']');
  if (open == std::string::npos) {
    return {path, 0};
  }
  return {path.substr(0, open + 1) + path.substr(close),
          std::stoul(path.substr(open + 1, close - open - 1))};
}

void check_path(const Scene& scene, const std::string& path, std::vector<std::string>& notes) {
  const auto [pattern, index] = pattern_of(path);
  for (const Rule& rule : rules) {
    if (pattern == rule.pattern && rule.is_idle(scene, index)) {
      notes.push_back(path + " has no effect: " + rule.why);
    }
  }
}

// Every setting that was changed, down to the members of elements of lists.
void visit_changed(const Scene& scene, const Tree& tree, const std::string& path,
                   std::vector<std::string>& notes) {
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

std::vector<std::string> unused_in_one_stage(const Scene& scene) {
  std::vector<std::string> notes;
  const TreeWriter writer(Members::changed, InMemory::named);
  visit_changed(scene, {writer.write_struct(scene, ""), {}}, "", notes);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    for (const Material& material : scene.bodies[k].material) {
      const std::string why = std::visit(IdleMaterial{scene}, material);
      if (!why.empty()) {
        const char* kind = std::visit([](const auto& known) { return known.kind; }, material);
        notes.push_back(element_path("bodies", k) + ".material: " + kind +
                        " has no effect: " + why);
      }
    }
  }
  return notes;
}

}  // namespace

std::vector<std::string> unused_settings(const Scene& scene) {
  std::vector<std::string> notes = unused_in_one_stage(scene);
  if (scene.stages.empty()) {
    return notes;
  }
  const std::size_t of_first = notes.size();
  for (const StageScene& stage : stage_scenes(with_resolved_files(scene))) {
    for (const std::string& note : unused_in_one_stage(stage.scene)) {
      const auto end = notes.begin() + static_cast<std::ptrdiff_t>(of_first);
      if (!stage.name.empty() && std::find(notes.begin(), end, note) == end) {
        notes.push_back(message("stage ", stage.name, ": ", note));
      }
    }
  }
  return notes;
}

}  // namespace lapilli
