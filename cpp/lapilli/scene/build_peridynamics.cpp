#include "lapilli/scene/build_peridynamics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "lapilli/geometry/combine.hpp"
#include "lapilli/peridynamics/build.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/fluid_frame.hpp"
#include "lapilli/scene/place_errors.hpp"

namespace lapilli {
namespace {

std::string wall_path(std::size_t index) { return element_path("peridynamics.walls", index); }

double spacing_of(const Scene& scene, const std::vector<FilledPoints>& filled) {
  for (std::size_t k = 1; k < filled.size(); ++k) {
    require_at(std::abs(filled[k].spacing / filled[0].spacing - 1.0) < 1e-6, scene,
               element_path("bodies", k), "has points ", filled[k].spacing,
               " m apart, those of body 0 are ", filled[0].spacing,
               " m apart; a peridynamic fluid has one spacing");
  }
  const double spacing = filled[0].spacing;
  if (flows(scene)) {
    return spacing;  // that of its frame
  }
  const double share = scene.grid.cell / spacing;
  require_at(std::abs(share - std::round(share)) < 1e-6 * share, scene, "bodies.0", "has points ",
             spacing, " m apart, which do not fit cells of ", scene.grid.cell, " m");
  return spacing;
}

/// Signed distance from the union of the fluid bodies.
FluidDistance region_of(const Scene& scene) {
  std::vector<Shape> shapes;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const std::optional<Shape> shape = placed_shape(scene.bodies[k]);
    require_at(shape.has_value(), scene, element_path("bodies", k),
               "needs a shape: walls are found by their distance from it");
    shapes.push_back(*shape);
  }
  return [all = Union{std::move(shapes)}](const Vec3& at) { return all.distance(at); };
}

double longest_horizon(const PeridynamicsSettings& settings, double spacing) {
  if (!settings.flow) {
    return spacing * settings.heat->widest_horizon();
  }
  const double thermal = settings.heat ? for_flow(*settings.heat).widest_horizon() : 0.0;
  return spacing * std::max(thermal, settings.flow->horizon);
}

Fluid fluid_of(const Scene& scene) {
  Fluid fluid;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    FluidBody start;
    start.body = static_cast<int>(k);
    start.temperature = body.temperature;
    start.source = body.source;
    start.velocity = body.velocity;
    fluid.bodies.push_back(start);
  }
  // validate() has seen to it that all bodies have the same.
  if (const auto* thermal = material_in<Thermal>(scene.bodies[0])) {
    fluid.thermal = *thermal;
  }
  if (const auto* newtonian = material_in<Newtonian>(scene.bodies[0])) {
    fluid.newtonian = *newtonian;
  }
  return fluid;
}

/// Sites of the lattice that walls have taken so far.
using Sites = std::set<std::array<long, 3>>;

struct Reach {
  FluidDistance region;
  double horizon = 0.0;  // m
};

/// Those of a wall's points that the fluid can feel and that no wall before it has.
FilledPoints felt_points(const FilledPoints& all, const std::string& name, const Reach& reach,
                         const FluidFrame& frame, Sites& taken) {
  FilledPoints kept;
  kept.dimension = all.dimension;
  kept.spacing = all.spacing;
  bool felt = false;
  for (std::size_t row = 0; row < all.size(); ++row) {
    const Vec3 at = all.place(row);
    const double outside = reach.region(at);
    require(outside >= -0.3 * all.spacing, "wall '", name, "' overlaps the fluid body: its point ",
            "at (", at[0], ", ", at[1], ", ", at[2], ") lies ", -outside,
            " m inside the fluid region");
    if (outside > reach.horizon || outside <= 1e-6 * all.spacing) {
      continue;  // out of reach, or on the surface, where the fluid has its point
    }
    felt = true;
    if (taken.insert(frame.site(at)).second) {  // points sit in the middle of their boxes
      kept.position.insert(kept.position.end(), at.data(), at.data() + all.dimension);
      kept.volume.push_back(all.volume[row]);
    }
  }
  require(felt, "wall '", name, "' has no point within the horizon of ", reach.horizon,
          " m of the fluid");
  require(!kept.volume.empty(), "wall '", name,
          "' has no point of its own: the walls before it hold all of its places");
  return kept;
}

}  // namespace

bool conducts_at_rest(const Scene& scene) {
  return scene.peridynamics && scene.peridynamics->heat && !scene.peridynamics->flow &&
         scene.peridynamics->heat->laplacian == Laplacian::corrected;
}

bool flows(const Scene& scene) { return scene.peridynamics && scene.peridynamics->flow; }

std::vector<FilledPoints> fill_walls(const Scene& scene, const std::vector<FilledPoints>& filled) {
  std::vector<FilledPoints> walls;
  if (!scene.peridynamics) {
    return walls;
  }
  const double spacing = spacing_of(scene, filled);
  const Reach reach{region_of(scene), longest_horizon(*scene.peridynamics, spacing)};
  const int per_axis = static_cast<int>(std::lround(scene.grid.cell / spacing));
  const FluidFrame frame(scene, per_axis);
  FillOptions options;
  options.within = grid_bounds(scene);
  Sites taken;
  for (std::size_t k = 0; k < scene.peridynamics->walls.size(); ++k) {
    const FluidWallBody& wall = scene.peridynamics->walls[k];
    at_place(scene, wall_path(k), [&] {
      const FilledPoints all = frame.fill(wall.shape, options, dimension_of(scene));
      walls.push_back(felt_points(all, wall.name, reach, frame, taken));
    });
  }
  return walls;
}

std::vector<std::unique_ptr<Physics>> physics_of_peridynamics(
    const Scene& scene, const std::vector<FilledPoints>& filled, Points& points) {
  PeridynamicScene problem;
  problem.spacing = spacing_of(scene, filled);
  problem.region = region_of(scene);
  problem.fluid = fluid_of(scene);
  for (std::size_t k = 0; k < scene.peridynamics->walls.size(); ++k) {
    const FluidWallBody& wall = scene.peridynamics->walls[k];
    problem.walls.push_back({wall, static_cast<int>(scene.bodies.size() + k)});
    problem.wall_shapes.push_back(
        [shape = wall.shape](const Vec3& at) { return distance(shape, at); });
  }
  problem.heat = scene.peridynamics->heat;
  problem.flow = scene.peridynamics->flow;
  return at_place(scene, "peridynamics", [&] { return build_peridynamics(points, problem); });
}

}  // namespace lapilli
