#include "lapilli/scene/build_parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/combine.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"
#include "lapilli/mpm/dynamics/plastic_heat.hpp"
#include "lapilli/mpm/dynamics/thermal_strain.hpp"
#include "lapilli/mpm/heat/heat_in_body_frame.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/heat/particle_heat.hpp"
#include "lapilli/mpm/quasi_static/quasi_static.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/build_motion.hpp"
#include "lapilli/scene/build_peridynamics.hpp"
#include "lapilli/scene/common_motion.hpp"
#include "lapilli/scene/heat_obstacles.hpp"
#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/stress_at_start.hpp"

namespace lapilli {
namespace {

using PhysicsList = std::vector<std::unique_ptr<Physics>>;
using Parts = Simulation::Stage::Parts;

template <int Dim>
Grid<Dim> grid_of(const Scene& scene) {
  return in_file(scene, "grid", [&] {
    return Grid<Dim>(Eigen::Map<const Vec<Dim>>(scene.grid.lower.data()),
                     Eigen::Map<const Vec<Dim>>(scene.grid.upper.data()), scene.grid.cell);
  });
}

std::unique_ptr<Points> points_of(const Scene& scene, const std::vector<FilledPoints>& filled,
                                  const std::vector<FilledPoints>& walls) {
  auto points = std::make_unique<Points>(dimension_of(scene));
  int body = 0;
  for (const auto& group : {&filled, &walls}) {
    for (const FilledPoints& some : *group) {
      points->append(some.position, some.volume, body++);
    }
  }
  return points;
}

// The shapes of all bodies where they stand; none where a body is known by its points only.
std::vector<Shape> shapes_of(const Scene& scene) {
  std::vector<Shape> shapes;
  for (const Body& body : scene.bodies) {
    const std::optional<Shape> shape = placed_shape(body);
    if (!shape) {
      return {};
    }
    shapes.push_back(*shape);
  }
  return shapes;
}

// Distance to the union of the bodies; none where a body is known by its points only.
DistanceFunction distance_of(const Scene& scene) {
  std::vector<Shape> shapes = shapes_of(scene);
  if (shapes.empty()) {
    return {};
  }
  return [all = Union{std::move(shapes)}](const Vec3& at) { return all.distance(at); };
}

// The box of a point is half its spacing wide on each side, whatever its volume.
double half_width_of(const Scene& scene, const FilledPoints& filled) {
  return std::min(0.5, 0.5 * filled.spacing / scene.grid.cell);
}

template <int Dim>
std::unique_ptr<Physics> heat_of(const Scene& scene, const Grid<Dim>& grid,
                                 const Beginning& beginning, Points& points) {
  const std::vector<FilledPoints>& filled = beginning.filled;
  HeatProblem<Dim> problem{grid,
                           scene.grid.shape_function,
                           {},
                           *scene.heat,
                           beginning.initial ? DistanceFunction() : distance_of(scene),
                           has_moving_points(scene)};
  if (scene.dynamics) {
    for (const GridBoundary& wall : scene.dynamics->grid_boundaries) {
      std::visit(
          [&](const auto& known) { problem.walls[static_cast<std::size_t>(known.face)] = true; },
          wall);
    }
    problem.obstacles = heat_obstacles(scene);
    problem.separates = true;
  }
  problem.frame = common_motion(scene);
  problem.fixed_steps = scene.time.step || scene.time.steps;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    problem.bodies.push_back({*material_in<Thermal>(body), half_width_of(scene, filled[k]),
                              body.temperature, body.source,
                              beginning.goes_on(k) ? std::nullopt : placed_shape(body), body.name});
  }
  return at_place(scene, "heat", [&] { return make_heat<Dim>(points, std::move(problem)); });
}

std::unique_ptr<Physics> quasi_static_of(const Scene& scene, Points& points) {
  std::vector<Solid> materials;
  std::vector<char> in_cells;
  for (const Body& body : scene.bodies) {
    materials.push_back(solids_in(body).front());
    in_cells.push_back(is_filled_in_place(scene, body));
  }
  return at_place(scene, "quasi_static", [&] {
    return make_quasi_static(points, place(scene.grid.lower), place(scene.grid.upper),
                             scene.grid.cell, scene.grid.shape_function, std::move(materials),
                             *scene.quasi_static, shapes_of(scene), in_cells);
  });
}

// A translation and a spin; empty for a body at rest.
std::function<Vec3(const Vec3&)> velocity_at_start(const Body& body, const FilledPoints& filled,
                                                   int dimension) {
  const Vec3 start = place(body.velocity);
  if (body.spin.empty()) {
    return body.velocity.empty() ? std::function<Vec3(const Vec3&)>()
                                 : [start](const Vec3&) { return start; };
  }
  const Vec3 spin = dimension == 2 ? Vec3(0.0, 0.0, body.spin.front()) : place(body.spin);
  Vec3 center = place(body.spin_center);
  if (body.spin_center.empty()) {
    double volume = 0.0;
    for (std::size_t k = 0; k < filled.volume.size(); ++k) {
      volume += filled.volume[k];
      for (int axis = 0; axis < dimension; ++axis) {
        center[axis] += filled.volume[k] * filled.position[k * dimension + axis];
      }
    }
    center /= volume;
  }
  return [=](const Vec3& at) { return Vec3(start + spin.cross(at - center)); };
}

template <int Dim>
std::unique_ptr<Dynamics<Dim>> dynamics_of(const Scene& scene, const Grid<Dim>& grid,
                                           const Beginning& beginning, Points& points) {
  const std::vector<FilledPoints>& filled = beginning.filled;
  const std::optional<InitialState>& initial = beginning.initial;
  DynamicsProblem<Dim> problem{
      grid,
      scene.grid.shape_function,
      {},
      *scene.dynamics,
      initial ? DistanceFunction() : distance_of(scene)};  // bodies that go on have moved
  const StressAtStart stress(scene, beginning.time);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const std::string& name = scene.bodies[k].name;
    DynamicsBody body{solids_in(scene.bodies[k]).front(), half_width_of(scene, filled[k]), {}, {}};
    body.name = name;
    body.label = name.empty() ? message("body ", k) : message("body '", name, "'");
    body.spacing = filled[k].spacing;
    if (beginning.goes_on(k)) {
      problem.bodies.push_back(std::move(body));
      continue;
    }
    body.velocity = velocity_at_start(scene.bodies[k], filled[k], Dim);
    body.stress = stress.of(k);
    body.shape = placed_shape(scene.bodies[k]);
    problem.bodies.push_back(std::move(body));
  }
  problem.notes = [&stress] { return stress.notes(); };
  problem.start = beginning.start;
  return at_place(scene, "dynamics", [&] { return make_dynamics<Dim>(points, problem); });
}

// The coefficient of a coupling in every body, zero where it is absent; empty where no body has it.
template <class Coupling>
std::vector<double> coupling_of(const Scene& scene, double Coupling::*member) {
  std::vector<double> values;
  bool any = false;
  for (const Body& body : scene.bodies) {
    values.push_back(0.0);
    for (const Material& material : body.material) {
      if (const auto* coupling = std::get_if<Coupling>(&material)) {
        values.back() = coupling->*member;
        any = true;
      }
    }
  }
  return any ? values : std::vector<double>{};
}

// Couplings stand between heat and momentum: what heat did this step expands, and what momentum
// dissipated in the step before heats.
template <int Dim>
void couple(const Scene& scene, const Beginning& beginning, Points& points, ParticleHeat<Dim>& heat,
            Dynamics<Dim>& dynamics, PhysicsList& physics) {
  const Archive* before = beginning.start ? beginning.start->state.get() : nullptr;
  if (before != nullptr) {
    heat.go_on(*beginning.start);
  }
  heat.follow({[&dynamics] { return dynamics.speed(); },
               [&dynamics] { return dynamics.step_limit().automatic; }});
  at_place(scene, "heat.contacts", [&] {
    require(dynamics.has_contacts() || scene.heat->contacts.empty(),
            "all bodies are bonded and share their temperatures; say dynamics.contacts.contact = "
            "\"frictional\" for those that resist heat");
  });
  if (dynamics.has_contacts()) {
    heat.separate(dynamics.node_fields(), dynamics.touches());
  }
  std::vector<FindFeet<Dim>> feet;
  for (const HeatObstacle& obstacle : heat_obstacles(scene)) {
    const auto number = static_cast<std::size_t>(obstacle.number);
    feet.push_back([&dynamics, number] { return dynamics.feet(number); });
  }
  if (!feet.empty()) {
    heat.touch(std::move(feet));
  }
  if (heat.carried_gradient() != nullptr) {
    dynamics.turn(*heat.carried_gradient());
  }
  const auto shares = coupling_of(scene, &PlasticHeating::share);
  if (!shares.empty()) {
    heat.expect_plastic();
    if (before && before->contains("dynamics/plastic")) {
      beginning.start->fetch("dynamics/plastic", points, dynamics.plastic_work());
    }
    physics.push_back(std::make_unique<PlasticHeat>(
        points, dynamics.plastic_work(), heat.carried_temperature(), heat.capacity(), shares,
        [&heat](double joule) { heat.book_plastic(joule); }));
  }
  if (scene.dynamics->outside == Outside::remove) {
    heat.expect_removed();
  }
  const auto coefficients = coupling_of(scene, &ThermalExpansion::coefficient);
  if (!coefficients.empty()) {
    auto strain = std::make_unique<ThermalStrain>(points, heat.carried_temperature(),
                                                  dynamics.free_strain(), coefficients);
    if (const SubCycle* own = heat.sub_cycle()) {
      strain->follow(own->change(), [own] { return own->ahead(); });
    }
    physics.push_back(std::move(strain));
  }
}

template <int Dim>
Parts parts_in(const Scene& scene, const Beginning& beginning) {
  const Grid<Dim> grid = grid_of<Dim>(scene);
  const std::vector<FilledPoints> walls = fill_walls(scene, beginning.filled);
  std::unique_ptr<Points> points = beginning.initial ? beginning.initial->points(beginning.filled)
                                                     : points_of(scene, beginning.filled, walls);
  PhysicsList physics;
  if (scene.heat) {
    physics.push_back(heat_of<Dim>(scene, grid, beginning, *points));
  }
  if constexpr (Dim > 1) {
    if (scene.dynamics) {
      auto dynamics = dynamics_of<Dim>(scene, grid, beginning, *points);
      if (scene.heat) {
        couple<Dim>(scene, beginning, *points, dynamic_cast<ParticleHeat<Dim>&>(*physics.front()),
                    *dynamics, physics);
      }
      physics.push_back(std::move(dynamics));
    }
  }
  if (scene.quasi_static) {
    physics.push_back(quasi_static_of(scene, *points));
  }
  if (scene.peridynamics) {
    for (auto& one : physics_of_peridynamics(scene, beginning.filled, *points)) {
      physics.push_back(std::move(one));
    }
  }
  add_motion<Dim>(scene, *points, physics);
  return {std::move(points), std::move(physics), {}};
}

}  // namespace

Simulation::Stage::Parts parts_of(const Scene& scene, const Beginning& beginning) {
  switch (dimension_of(scene)) {
    case 1:
      return parts_in<1>(scene, beginning);
    case 2:
      return parts_in<2>(scene, beginning);
    default:
      return parts_in<3>(scene, beginning);
  }
}

}  // namespace lapilli
