#include "lapilli/scene/memory.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/memory.hpp"
#include "lapilli/geometry/support.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/common_motion.hpp"
#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/stage_scenes.hpp"

namespace lapilli {
namespace {

constexpr int samples[] = {1024, 48, 16};  // along each axis, in scenes of 1, 2 and 3 dimensions

/// The part of a shape's box that lies in the grid.
Bounds inside_grid(const Bounds& box, const Bounds& grid) {
  return {box.lower.cwiseMax(grid.lower), box.upper.cwiseMin(grid.upper)};
}

/// Share of a box that a shape fills, at least that of half a sample.
double share_filled(const Shape& shape, const Bounds& box, int dimension) {
  const int along = samples[dimension - 1];
  const auto all = static_cast<Index>(std::lround(std::pow(along, dimension)));
  Index inside = 0;
  for (Index k = 0; k < all; ++k) {
    allow_interruption();
    Vec3 at = Vec3::Zero();
    Index rest = k;
    for (int axis = 0; axis < dimension; ++axis, rest /= along) {
      const double share = (static_cast<double>(rest % along) + 0.5) / along;
      at[axis] = box.lower[axis] + share * (box.upper[axis] - box.lower[axis]);
    }
    inside += distance(shape, at) <= 0.0 ? 1 : 0;
  }
  return std::max(0.5, static_cast<double>(inside)) / static_cast<double>(all);
}

double points_in(const Scene& scene, const Shape& shape, double per_cell) {
  const int dimension = dimension_of(scene);
  check(shape, dimension);
  const Bounds box = inside_grid(bounds(shape), grid_bounds(scene));
  double cells = 1.0;
  for (int axis = 0; axis < dimension; ++axis) {
    cells *= std::max(0.0, box.upper[axis] - box.lower[axis]) / scene.grid.cell;
  }
  return cells > 0.0 ? per_cell * cells * share_filled(shape, box, dimension) : 0.0;
}

double points_of(const Scene& scene, const Body& body) {
  const int dimension = dimension_of(scene);
  if (body.points) {
    return static_cast<double>(body.points->volumes.size());
  }
  const std::optional<Shape> shape = placed_shape(body);
  const auto per_cell = static_cast<double>(
      body.points_per_cell.value_or(static_cast<int>(std::lround(std::pow(2.0, dimension)))));
  return shape ? points_in(scene, *shape, per_cell) : 0.0;
}

// Arrays of points, and of bonds: a neighbour, its weight and its conductance each.
double memory_of_peridynamics(const PeridynamicsSettings& settings, int dimension, double points) {
  constexpr double allowance = 1.6;  // for the search of neighbours, frames and checkpoint
  const auto bonds = [&](double horizon, double skin) {
    const double r = horizon + skin;
    return dimension == 1 ? 2.0 * r : dimension == 2 ? 3.2 * r * r : 4.2 * r * r * r;
  };
  double bytes = 8.0 * (4.0 + 2.0 * dimension);
  if (settings.heat) {
    const double horizon = settings.heat->horizon > 0.0 ? settings.heat->horizon : 1.5;
    bytes += 8.0 * 20.0 + 20.0 * bonds(horizon, settings.heat->skin);
  }
  if (settings.flow) {
    bytes += 8.0 * 40.0 + 12.0 * bonds(settings.flow->horizon, settings.flow->skin);
  }
  return allowance * bytes * points;
}

std::string span_of(double lower, double upper) { return message(lower, " to ", upper, " m"); }

/// Only what reaches out by more than the grid's own size is refused here, the rest point by point
/// once there are points. A box around a turned shape may be much larger than the shape: then only
/// one that misses the grid.
void require_within_reach(const Scene& scene, const Shape& shape, const std::string& path) {
  const Bounds grid = grid_bounds(scene);
  const int dimension = dimension_of(scene);
  double size = 0.0;
  for (int axis = 0; axis < dimension; ++axis) {
    size = std::max(size, grid.upper[axis] - grid.lower[axis]);
  }
  at_place(scene, path, [&] { check(shape, dimension); });
  const TightBounds there = tight_bounds(shape);
  const Bounds box = there.box;
  for (int axis = 0; axis < dimension; ++axis) {
    const double near = there.is_tight ? box.lower[axis] : box.upper[axis];
    const double far = there.is_tight ? box.upper[axis] : box.lower[axis];
    const bool below = std::isfinite(near) && near < grid.lower[axis] - size;
    const bool above = std::isfinite(far) && far > grid.upper[axis] + size;
    require_at(
        !below && !above, scene, path, "reaches far outside of the grid: along ", "xyz"[axis],
        " it spans ", span_of(box.lower[axis], box.upper[axis]), ", the grid ",
        span_of(grid.lower[axis], grid.upper[axis]),
        std::holds_alternative<Mesh>(shape) ? "; a file in millimetres needs scale = 0.001" : "");
  }
}

}  // namespace

// Arrays of points and nodes, and the rows of the assembled nodal operator: the most that a run
// that writes frames and checkpoints was seen to hold, at 4 to 700 thousand points of every method.
double memory_of(const Scene& scene, double nodes, double points) {
  const int dimension = dimension_of(scene);
  if (scene.peridynamics) {
    return memory_of_peridynamics(*scene.peridynamics, dimension, points);
  }
  double point_numbers = 4.0 + dimension + 4.0 * (1 + dimension);
  double node_numbers = scene.heat ? 16.0 + std::pow(5.0, dimension) : 4.0;
  double factor_numbers = 0.0;
  if (scene.quasi_static) {
    // Entries of the factor under nested dissection, n log n in the plane and n^4/3 in space.
    const double active = std::min(nodes, 1.4 * points / std::pow(2.0, dimension));
    const double unknowns = dimension * std::max(2.0, active);
    factor_numbers = dimension == 2 ? 20.0 * unknowns * std::log2(unknowns)
                                    : 110.0 * std::pow(unknowns, 4.0 / 3.0);
    point_numbers += 9.0;
  } else if (scene.dynamics) {
    node_numbers += 6.0 * dimension;
    point_numbers = (scene.heat ? point_numbers : 0.0) + (dimension == 2 ? 57.0 : 79.0);
  } else if (has_motion(scene)) {
    point_numbers += 27.0;
  }
  return 8.0 * (point_numbers * points + node_numbers * nodes + factor_numbers);
}

SizeEstimate size_of(const Scene& scene) {
  SizeEstimate size;
  size.nodes = 1.0;
  for (std::size_t axis = 0; axis < scene.grid.lower.size(); ++axis) {
    size.nodes *=
        1.0 + std::round((scene.grid.upper[axis] - scene.grid.lower[axis]) / scene.grid.cell);
  }
  for (const Body& body : scene.bodies) {
    size.points += points_of(scene, body);
  }
  size.memory = memory_of(scene, size.nodes, size.points);
  return size;
}

SizeEstimate largest_size_of(const Scene& scene) {
  SizeEstimate largest = size_of(scene);
  if (!scene.stages.empty()) {
    for (const StageScene& stage : stage_scenes(scene)) {
      const SizeEstimate size = size_of(stage.scene);
      if (size.memory > largest.memory) {
        largest = size;
        largest.stage = stage.name;
      }
    }
  }
  return largest;
}

void require_feasible(const Scene& scene) {
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (const std::optional<Shape> shape = placed_shape(scene.bodies[k])) {
      require_within_reach(scene, *shape, message("bodies.", k));
    }
  }
  if (scene.peridynamics) {
    for (std::size_t k = 0; k < scene.peridynamics->walls.size(); ++k) {
      require_within_reach(scene, scene.peridynamics->walls[k].shape,
                           message("peridynamics.walls.", k));
    }
  }
  const SizeEstimate size = largest_size_of(scene);
  const double available = available_memory();
  const std::string bodies =
      size.stage.empty() ? "the bodies" : "the bodies of stage '" + size.stage + "'";
  require_at(size.memory <= available, scene, "grid", "has ", size.nodes, " nodes, and ", bodies,
             " about ", size.points, " points: about ", readable_bytes(size.memory),
             " of memory, of which ", readable_bytes(available),
             " are available; a larger grid.cell takes less");
}

}  // namespace lapilli
