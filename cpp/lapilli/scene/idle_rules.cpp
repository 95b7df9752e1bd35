#include "lapilli/scene/idle_rules.hpp"

#include <algorithm>

#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/common_motion.hpp"
#include "lapilli/scene/validate_heat.hpp"

namespace lapilli {

bool without_heat(const Scene& scene) {
  return !scene.heat && !(scene.peridynamics && scene.peridynamics->heat);
}

namespace {

/// Whether every boundary condition of heat holds a temperature.
bool without_fluxes(const Scene& scene) {
  return !scene.heat || std::ranges::all_of(scene.heat->boundaries, holds_temperature);
}
bool without_exchange(const Scene& scene) {
  return !scene.heat || std::ranges::none_of(scene.heat->boundaries, exchanges);
}
bool without_normals(const Scene& scene) {
  return scene.heat->boundaries.empty() || scene.heat->method == FluxMethod::node ||
         scene.heat->method == FluxMethod::paper;
}
/// Whether the solver of heat has one way of stepping, which is explicit.
bool is_always_explicit(const Scene& scene) {
  const bool varies = std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& body) {
    const auto* thermal = material_in<Thermal>(body);
    return thermal != nullptr && thermal->varies();
  });
  return varies || !scene.heat->contacts.empty() || is_heat_of_points(scene);
}
bool without_adaptive_steps(const Scene& scene) {
  return scene.heat->time_integration != TimeIntegration::automatic || scene.time.step ||
         scene.time.steps || is_always_explicit(scene);
}

bool without_gravity(const Scene& scene) {
  const std::vector<double>& gravity = scene.dynamics->gravity;
  return std::all_of(gravity.begin(), gravity.end(), [](double one) { return one == 0.0; });
}
/// Whether the obstacle starts without turning and goes on so.
bool without_turning(const Obstacle& obstacle) {
  return !obstacle.mass && obstacle.revolutions_per_second == 0.0;
}
bool points_are_given(const Scene& scene, std::size_t k) { return !scene.bodies[k].shape; }
bool without_frames(const Scene& scene) { return scene.output.path.empty(); }
bool without_flow(const Scene& scene) { return !scene.peridynamics->flow; }
bool without_supports(const Scene& scene) { return scene.quasi_static->supports.empty(); }
const PeridynamicFlowSettings& flow_of(const Scene& scene) { return *scene.peridynamics->flow; }
bool has_sound_speed(const Scene& scene) { return flow_of(scene).sound_speed > 0.0; }

/// A condition on the scene alone, whichever element a setting belongs to.
template <bool (*holds)(const Scene&)>
bool whole(const Scene& scene, std::size_t) {
  return holds(scene);
}

constexpr IdleRule rules[] = {
    {"grid.shape_function",
     [](const Scene& scene, std::size_t) { return scene.peridynamics.has_value(); },
     "peridynamics uses no shape functions"},
    {"bodies[].temperature", whole<without_heat>, "the scene has no heat"},
    {"bodies[].source", whole<without_heat>, "the scene has no heat"},
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
    {"bodies[].points_per_cell", points_are_given, "the points are given"},
    {"bodies[].jitter", points_are_given, "the points are given"},
    {"bodies[].random", points_are_given, "the points are given"},
    {"heat.method", whole<without_fluxes>, "no boundary condition prescribes a flux"},
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
     "heat takes explicit steps here, or the step is given"},
    {"heat.tolerance", whole<without_adaptive_steps>,
     "heat chooses no steps of its own here: time_integration is not auto, the step is given, or "
     "the solver is explicit"},
    {"heat.blend",
     [](const Scene& scene, std::size_t) {
       const HeatTransfer transfer = scene.heat->transfer;
       return !(transfer == HeatTransfer::affine ||
                (transfer == HeatTransfer::automatic && has_moving_points(scene)));
     },
     "only heat.transfer = affine blends"},
    {"heat.surface_fraction",
     [](const Scene& scene, std::size_t) { return scene.heat->method != FluxMethod::paper; },
     "heat.method is not paper"},
    {"heat.normal_smoothing", whole<without_normals>,
     "no boundary condition asks for smooth normals"},
    {"heat.corner_fit", whole<without_normals>, "no boundary condition asks for corners"},
    {"heat.implicit_robin", whole<without_exchange>, "there is neither convection nor radiation"},
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
    {"dynamics.gravity_factor", whole<without_gravity>, "there is no dynamics.gravity"},
    {"dynamics.damping_until",
     [](const Scene& scene, std::size_t) { return scene.dynamics->local_damping == 0.0; },
     "there is no dynamics.local_damping"},
    {"dynamics.blend_rate",
     [](const Scene& scene, std::size_t) {
       return scene.dynamics->transfer != VelocityTransfer::blended_apic;
     },
     "dynamics.transfer is not blended_apic"},
    {"dynamics.obstacles[].center",
     [](const Scene& scene, std::size_t k) {
       return without_turning(scene.dynamics->obstacles[k]);
     },
     "the obstacle does not turn"},
    {"dynamics.obstacles[].axis",
     [](const Scene& scene, std::size_t k) {
       return dimension_of(scene) < 3 || without_turning(scene.dynamics->obstacles[k]);
     },
     "the obstacle turns about no axis"},
    {"dynamics.obstacles[].factor",
     [](const Scene& scene, std::size_t k) {
       const Obstacle& obstacle = scene.dynamics->obstacles[k];
       return obstacle.velocity.empty() && without_turning(obstacle);
     },
     "the obstacle is at rest"},
    {"bodies[].motion.axis",
     [](const Scene& scene, std::size_t) { return dimension_of(scene) < 3; },
     "in two dimensions there is one axis"},
    {"quasi_static.enforcement", whole<without_supports>, "there are no supports"},
    {"quasi_static.bandwidth",
     [](const Scene& scene, std::size_t) {
       return without_supports(scene) || scene.quasi_static->enforcement == Enforcement::nitsche;
     },
     "no support has a stiff constraint"},
    {"quasi_static.gap_bandwidth",
     [](const Scene& scene, std::size_t) {
       return without_supports(scene) ||
              (scene.quasi_static->enforcement != Enforcement::mean_gap &&
               scene.quasi_static->enforcement != Enforcement::nitsche);
     },
     "no support has a moderate constraint"},
    {"quasi_static.hold_empty_cells", whole<without_supports>, "there are no supports"},
    {"quasi_static.max_penetration", whole<without_supports>, "there are no supports"},
    {"peridynamics.heat.viscous_dissipation", whole<without_flow>,
     "nothing flows without [peridynamics.flow]"},
    {"peridynamics.heat.zero_energy",
     [](const Scene& scene, std::size_t) {
       return scene.peridynamics->heat->laplacian != Laplacian::zero_energy;
     },
     "its laplacian is not zero-energy"},
    {"peridynamics.flow.zero_energy",
     [](const Scene& scene, std::size_t) {
       return flow_of(scene).laplacian != Laplacian::zero_energy;
     },
     "its laplacian is not zero-energy"},
    {"peridynamics.walls[].slip", whole<without_flow>, "nothing flows without [peridynamics.flow]"},
    {"peridynamics.walls[].velocity", whole<without_flow>,
     "nothing flows without [peridynamics.flow]"},
    {"peridynamics.flow.sound_speed_factor", whole<has_sound_speed>, "sound_speed is given"},
    {"peridynamics.flow.length", whole<has_sound_speed>, "sound_speed is given"},
    {"peridynamics.flow.temperature_range", whole<has_sound_speed>, "sound_speed is given"},
    {"output.fields", whole<without_frames>, "there is no output.path"},
    {"output.precision", whole<without_frames>, "there is no output.path"},
    {"output.compression", whole<without_frames>, "there is no output.path"},
    {"output.checkpoint_every",
     [](const Scene& scene, std::size_t) { return !scene.output.checkpoint; },
     "output.checkpoint is off"},
};

}  // namespace

std::span<const IdleRule> idle_rules() { return rules; }

}  // namespace lapilli
