#include "lapilli/scene/check.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>

#include "lapilli/core/memory.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/says_model.hpp"
#include "lapilli/core/seconds_since.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/scene/audit.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/body_volumes.hpp"
#include "lapilli/scene/build.hpp"
#include "lapilli/scene/check_large.hpp"
#include "lapilli/scene/check_stages.hpp"
#include "lapilli/scene/check_steps.hpp"
#include "lapilli/scene/common_motion.hpp"
#include "lapilli/scene/memory.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/run_scene.hpp"
#include "lapilli/scene/validate.hpp"
#include "lapilli/scene/validate_heat.hpp"

namespace lapilli {
namespace {

using Clock = std::chrono::steady_clock;

// What is looked at by building it; beyond, by its bounds.
constexpr double most_points = 2e6, most_memory = 2e9;  // bytes

void describe_grid(const Scene& scene, CheckReport& report) {
  report.dimension = dimension_of(scene);
  report.nodes = 1;
  for (std::size_t axis = 0; axis < scene.grid.lower.size(); ++axis) {
    const double length = scene.grid.upper[axis] - scene.grid.lower[axis];
    report.cells.push_back(std::lround(length / scene.grid.cell));
    report.nodes *= report.cells.back() + 1;
  }
}

void describe_bodies(const Scene& scene, const Simulation& simulation, CheckReport& report) {
  const Points& points = simulation.points();
  report.points = points.size();
  const std::vector<BodyVolume> volumes = body_volumes(scene, points);
  for (const BodyVolume& body : volumes) {
    report.bodies.push_back({body.name, 0, 0.0, 0.0, body.of_shape});
  }
  report.notes = volume_warnings(volumes, points.dimension());
  std::ranges::copy(packing_warnings(scene, points), std::back_inserter(report.notes));
  if (scene.peridynamics) {
    for (const FluidWallBody& wall : scene.peridynamics->walls) {
      report.bodies.push_back({message("wall ", wall.name), 0, 0.0, 0.0, {}});
    }
  }
  for (Index row = 0; row < points.size(); ++row) {
    CheckReport::BodyReport& body = report.bodies[static_cast<std::size_t>(points.body()[row])];
    ++body.points;
    body.volume += points.volume()[row];
  }
  for (CheckReport::BodyReport& body : report.bodies) {
    body.spacing = std::pow(body.volume / static_cast<double>(body.points), 1.0 / report.dimension);
  }
}

void describe_peridynamics(const Scene& scene, CheckReport& report) {
  const PeridynamicsSettings& settings = *scene.peridynamics;
  (settings.heat ? report.modelled : report.not_modelled).push_back("peridynamic heat conduction");
  (settings.flow ? report.modelled : report.not_modelled).push_back("viscous flow");
  if (settings.heat && settings.flow) {
    const bool full = settings.flow->buoyancy == Buoyancy::full;
    report.modelled.push_back(full ? "buoyancy by all of the weight" : "buoyancy");
    (settings.heat->viscous_dissipation ? report.modelled : report.not_modelled)
        .push_back("viscous heating");
  }
  if (settings.walls.empty()) {
    report.say("peridynamics.no-walls", "[peridynamics] has no walls: nothing holds the fluid");
  }
  std::ranges::copy(heat_warnings(scene), std::back_inserter(report.notes));
  for (const char* absent : {"free surfaces", "properties that depend on temperature",
                             "heat within walls", "radiation", "turbulence"}) {
    report.not_modelled.push_back(absent);
  }
}

void describe_heat(const Scene& scene, CheckReport& report) {
  if (!scene.heat) {
    report.not_modelled.push_back("heat");
    return;
  }
  report.modelled.push_back("heat conduction");
  std::ranges::copy(heat_warnings(scene), std::back_inserter(report.notes));
  for (const char* condition : modelled_by(scene.heat->boundaries)) {
    report.modelled.push_back(condition);
  }
  if (scene.heat->boundaries.empty()) {
    report.say("heat.no-boundaries", "[heat] has no boundaries: all surfaces are insulated");
  }
  bool varies = false, melts = false;
  for (const Body& body : scene.bodies) {
    if (const auto* material = material_in<Thermal>(body)) {
      varies = varies || material->specific_heat.varies() || material->conductivity.varies();
      melts = melts || material->melts();
    }
  }
  const auto list = [&](bool modelled, const char* what) {
    (modelled ? report.modelled : report.not_modelled).push_back(what);
  };
  list(varies, "temperature-dependent properties");
  list(melts, "melting");
  list(!scene.heat->contacts.empty(), "thermal contact resistance");
  list(false, "radiation between surfaces");
}

void describe_quasi_static(const Scene& scene, CheckReport& report) {
  if (!scene.quasi_static) {
    report.not_modelled.push_back("equilibrium under load steps");
    return;
  }
  report.modelled.push_back("equilibrium under load steps");
  const QuasiStaticSettings& settings = *scene.quasi_static;
  if (!settings.supports.empty()) {
    report.modelled.push_back(message("implicit walls (", name_of(settings.enforcement), ")"));
  }
  if (!settings.tractions.empty()) {
    report.modelled.push_back("tractions");
  }
  for (const char* absent : {"inertia", "large strains", "friction", "walls that let go"}) {
    report.not_modelled.push_back(absent);
  }
  for (const Body& body : scene.bodies) {
    if (body.shape && !is_filled_exactly(scene, body)) {
      report.say("quasi_static.lattice-fill", "body ", body.name,
                 " is filled by a lattice: its points integrate cut cells "
                 "roughly; set fill = \"exact\"");
    }
  }
  if (!settings.hold_empty_cells && scene.grid.shape_function == ShapeFunction::linear) {
    report.say(
        "quasi_static.empty-cells",
        "hold_empty_cells is off and shape functions are linear: a wall that moves into a cell "
        "without points lets go");
  }
}

// Where the default transfer is weaker than elsewhere.
void describe_transfer(const Scene& scene, CheckReport& report) {
  if (scene.dynamics->transfer != VelocityTransfer::blended_apic) {
    return;
  }
  if (scene.grid.shape_function == ShapeFunction::linear) {
    report.say(
        "dynamics.no-affine-part",
        "dynamics.transfer blended_apic has no affine part with linear functions: spin fades");
  }
  const double enough = 0.75 * scene.grid.cell;
  for (const CheckReport::BodyReport& body : report.bodies) {
    if (body.spacing > enough) {
      report.say("dynamics.few-points", "body ", body.name, " has fewer than ",
                 1 << report.dimension,
                 " points per cell: with dynamics.transfer blended_apic it may "
                 "fall apart after some 10,000 steps");
    }
  }
}

void describe_dynamics(const Scene& scene, CheckReport& report) {
  if (!scene.dynamics) {
    report.not_modelled.push_back("explicit dynamics");
    return;
  }
  report.modelled.push_back(report.dimension == 2 ? "explicit dynamics in plane strain"
                                                  : "explicit dynamics");
  const DynamicsSettings& settings = *scene.dynamics;
  if (settings.gravity.empty()) {
    report.not_modelled.push_back("gravity");
  } else {
    report.modelled.push_back("gravity");
  }
  for (const GridBoundary& wall : settings.grid_boundaries) {
    std::visit(
        [&](const auto& known) {
          report.modelled.push_back(message(known.kind, " wall ", name_of(known.face)));
        },
        wall);
  }
  for (const Obstacle& obstacle : settings.obstacles) {
    report.modelled.push_back(message(name_of(obstacle.contact), " obstacle ", obstacle.name,
                                      obstacle.name.empty() ? "" : ": ", kind_of(obstacle.shape),
                                      obstacle.mass ? ", moved by the forces on it" : "",
                                      obstacle.temperature ? ", exchanges heat" : "",
                                      obstacle.separation ? "" : ", without separation"));
  }
  for (const Body& body : scene.bodies) {
    for (const Material& material : body.material) {
      if (std::holds_alternative<ThermalExpansion>(material)) {
        report.modelled.push_back(message("thermal expansion of ", body.name));
      } else if (std::holds_alternative<PlasticHeating>(material)) {
        report.modelled.push_back(message("plastic heating of ", body.name));
      }
    }
  }
  for (const DynamicsBoundary& law : settings.boundaries) {
    report.modelled.push_back(std::visit([](const auto& known) { return known.kind; }, law));
  }
  if (settings.grid_boundaries.empty()) {
    report.say("dynamics.no-walls",
               "[dynamics] has no walls: a point that leaves the grid stops the run");
  }
  std::ranges::copy(warnings(settings), std::back_inserter(report.notes));
  describe_transfer(scene, report);
  for (const char* absent : {"pore pressure", "rate dependence"}) {
    report.not_modelled.push_back(absent);
  }
}

// What depends on how bodies lie is known once they are built.
void describe_choices(const Simulation& simulation, CheckReport& report) {
  for (const auto& physics : simulation.physics()) {
    if (const auto* chooser = dynamic_cast<const SaysModel*>(physics.get())) {
      std::ranges::copy(chooser->modelled(), std::back_inserter(report.modelled));
    }
    if (const auto* warner = dynamic_cast<const Warnings*>(physics.get())) {
      std::ranges::copy_if(warner->warnings(), std::back_inserter(report.notes),
                           [notes = report.notes](const Note& warning) {
                             return std::ranges::find(notes, warning) == notes.end();
                           });
    }
  }
}

void describe_physics(const Scene& scene, CheckReport& report) {
  if (scene.peridynamics) {
    describe_peridynamics(scene, report);
    return;
  }
  describe_heat(scene, report);
  describe_quasi_static(scene, report);
  describe_dynamics(scene, report);
  (has_motion(scene) ? report.modelled : report.not_modelled).push_back("prescribed rigid motion");
  if (!scene.quasi_static && !scene.dynamics) {
    report.not_modelled.push_back("deformation");
  }
}

void describe_step(const Scene& scene, Simulation& simulation, CheckReport& report) {
  report.step = simulation.next_step_size();
  report.hard_limit = std::numeric_limits<double>::infinity();
  report.step_reason = scene.time.step || scene.time.steps ? "given" : "automatic";
  for (const auto& physics : simulation.physics()) {
    const StepLimit limit = physics->step_limit();
    if (limit.hard < report.hard_limit) {
      report.hard_limit = limit.hard;
      report.step_reason += "; " + limit.reason;
    }
  }
}

// What a run leaves on disk, before compression: the fields asked for at every frame.
double output_of(const Scene& scene, Simulation& simulation) {
  const FrameOptions frames = frame_options(scene);
  double bytes = 0.0;
  for (const Field& field : simulation.fields()) {
    if (is_asked_for(field, frames)) {
      const int numbers = field.components == 1 ? 1 : field.components <= 3 ? 3 : 9;
      bytes += numbers * (frames.single ? 4.0 : 8.0);
    }
  }
  const double end = simulation.end(), every = scene.output.every.value_or(end);
  const double count = 2.0 + static_cast<double>(scene.stages.size()) +
                       (every > 0.0 ? std::floor(end / every) : 0.0);
  return bytes * count * static_cast<double>(simulation.points().size());
}

/// A scene that would take long or much is described by its bounds alone.
CheckReport estimate(const Scene& scene, const SizeEstimate& size) {
  CheckReport report;
  report.title = scene.title;
  describe_grid(scene, report);
  describe_physics(scene, report);
  report.points = static_cast<Index>(size.points);
  report.memory = size.memory;
  report.hard_limit = std::numeric_limits<double>::infinity();
  estimate_steps(scene, report);
  report.say("scene.not-built", "not built, since it is large: about ", size.points, " points and ",
             readable_bytes(size.memory), " by its bounds");
  return report;
}

}  // namespace

CheckReport check(const Scene& scene) {
  const Clock::time_point start = Clock::now();
  validate(with_resolved_files(scene));
  const SizeEstimate size = largest_size_of(with_resolved_files(scene));
  if (size.points > most_points || size.memory > most_memory) {
    require_feasible(with_resolved_files(scene));
    return estimate(scene, size);
  }
  const std::unique_ptr<Simulation> simulation = build(scene);
  CheckReport report;
  report.seconds_to_build = seconds_since(start);
  report.title = scene.title;
  describe_grid(scene, report);
  describe_bodies(scene, *simulation, report);
  describe_physics(scene, report);
  std::ranges::copy(unused_settings(scene), std::back_inserter(report.notes));
  describe_step(scene, *simulation, report);
  report.memory =
      memory_of(scene, static_cast<double>(report.nodes), static_cast<double>(report.points));
  if (!size.stage.empty()) {
    report.memory = std::max(report.memory, size.memory);
  }
  report.output = output_of(scene, *simulation);
  describe_stages(scene, *simulation, report);
  measure_steps(scene, *simulation, report);
  describe_choices(*simulation, report);  // how often heat steps is known by now
  return report;
}

}  // namespace lapilli
