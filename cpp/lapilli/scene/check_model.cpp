#include "lapilli/scene/check_model.hpp"

#include <algorithm>
#include <iterator>

#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/common_motion.hpp"
#include "lapilli/scene/validate_heat.hpp"

namespace lapilli {
namespace {

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
    report.modelled.push_back(
        message("supports that need not fit the grid (", name_of(settings.enforcement), ")"));
  }
  if (!settings.tractions.empty()) {
    report.modelled.push_back("tractions");
  }
  for (const char* absent : {"inertia", "large strains", "friction", "supports that let go"}) {
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
        "hold_empty_cells is off and shape functions are linear: a support that moves into a cell "
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
               "[dynamics] has no grid boundaries: a point that leaves the grid stops the run");
  }
  std::ranges::copy(warnings(settings), std::back_inserter(report.notes));
  describe_transfer(scene, report);
  for (const char* absent : {"pore pressure", "rate dependence"}) {
    report.not_modelled.push_back(absent);
  }
}

}  // namespace

void describe_model(const Scene& scene, CheckReport& report) {
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

}  // namespace lapilli
