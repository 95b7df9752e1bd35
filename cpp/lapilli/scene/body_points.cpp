#include "lapilli/scene/body_points.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/geometry/cell_fill.hpp"
#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/join_small.hpp"
#include "lapilli/geometry/sources.hpp"
#include "lapilli/geometry/support.hpp"
#include "lapilli/mpm/heat/asks_for_points.hpp"
#include "lapilli/scene/build_peridynamics.hpp"
#include "lapilli/scene/fluid_frame.hpp"
#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/scene_file.hpp"

namespace lapilli {
namespace {

std::string body_path(std::size_t index) { return element_path("bodies", index); }

Vec3 extent(const Bounds& box, int dimension) {
  Vec3 size = Vec3::Zero();
  for (int axis = 0; axis < dimension; ++axis) {
    size[axis] = box.upper[axis] - box.lower[axis];
  }
  return size;
}

std::string size_hint(const Shape& shape, const Vec3& size, const Vec3& grid) {
  const bool holds_mesh = std::holds_alternative<Mesh>(shape);
  const bool fits_in_millimetres = (1e-3 * size.array() <= grid.array()).all();
  return holds_mesh && fits_in_millimetres ? "; is it in millimetres? scale = 0.001" : "";
}

/// Before any point is made: where the shape stands and how large it is, for shapes whose bounds
/// are exact.
void require_shape_in_grid(const Scene& scene, const Body& body) {
  const int dimension = dimension_of(scene);
  check(*body.shape, dimension);
  const TightBounds there = tight_bounds(*placed_shape(body));
  const Bounds grid = grid_bounds(scene);
  const double slack = 1e-6 * scene.grid.cell;
  bool inside = true;
  for (int axis = 0; axis < dimension; ++axis) {
    const double lower = there.box.lower[axis], upper = there.box.upper[axis];
    inside &= std::isinf(lower) || lower >= grid.lower[axis] - slack;
    inside &= std::isinf(upper) || upper <= grid.upper[axis] + slack;
  }
  require(
      inside || !there.is_tight, "reaches out of the grid: its ", kind_of(*body.shape), " spans ",
      text_of(there.box.lower, dimension), " to ", text_of(there.box.upper, dimension),
      " m, the grid ", text_of(scene.grid.lower), " to ", text_of(scene.grid.upper), " m",
      inside ? "" : size_hint(*body.shape, extent(there.box, dimension), extent(grid, dimension)));
}

FilledPoints filled_shape(const Scene& scene, const Body& body) {
  const int dimension = dimension_of(scene);
  auto [lattice, options] = lattice_of(scene, body);
  if (is_filled_in_place(scene, body)) {
    const Vec3 margin = Vec3::Constant(scene.grid.cell);
    options.reach = {options.within.lower - margin, options.within.upper + margin};
    return fill_cells(*placed_shape(body), lattice, options, dimension);
  }
  options.clip = is_filled_exactly(scene, body) && !body.random;
  options.jitter = body.jitter;
  options.random = body.random;
  options.seed = static_cast<std::uint64_t>(body.seed);
  if (flows(scene)) {
    return FluidFrame(scene, lattice.points_per_axis).fill(*placed_shape(body), options, dimension);
  }
  FilledPoints points = fill(*body.shape, lattice, options, dimension);
  if (options.clip && body.jitter == 0.0 && (conducts_at_rest(scene) || scene.dynamics)) {
    // The smallest limit explicit steps of heat; alone before a wall they are what it pushes.
    join_small(points, 0.5);
  }
  return points;
}

FilledPoints given_points(const Scene& scene, const Body& body) {
  FilledPoints points;
  points.dimension = dimension_of(scene);
  points.position = body.points->positions;
  points.volume = body.points->volumes;
  require(points.position.size() == points.volume.size() * points.dimension, "points has ",
          points.position.size(), " coordinates and ", points.volume.size(),
          " volumes; each volume needs ", points.dimension, " coordinates");
  double total = 0.0;
  for (const double volume : points.volume) {
    require(std::isfinite(volume) && volume > 0.0, "points: volumes must be positive, got ",
            volume);
    total += volume;
  }
  require(!points.volume.empty(), "points holds no point");
  points.spacing = std::pow(total / static_cast<double>(points.size()), 1.0 / points.dimension);
  return points;
}

FilledPoints points_of_file(const Scene& scene, const Body& body) {
  const int dimension = dimension_of(scene);
  // Files without a column of volumes hold points of a regular fill.
  const double spacing = scene.grid.cell / points_along_axis(body, dimension);
  return read_points(body.points_file, dimension, std::pow(spacing, dimension));
}

FilledPoints points_of(const Scene& scene, const Body& body) {
  const bool has_file = !body.points_file.empty();
  const int sources = body.shape.has_value() + body.points.has_value() + has_file;
  require(sources > 0, "has no points: give a shape, points_file or points");
  require(sources == 1, "has several sources of points: give shape, points_file or points");
  if (body.shape) {
    require_shape_in_grid(scene, body);
  }
  return body.shape ? filled_shape(scene, body)
         : has_file ? points_of_file(scene, body)
                    : given_points(scene, body);
}

/// Whether the points of a body still have to be turned and moved to their places.
bool is_filled_elsewhere(const Scene& scene, const Body& body) {
  const bool is_placed = body.rotation != 0.0 || !body.translation.empty();
  return is_placed && !is_filled_in_place(scene, body) && !(body.shape && flows(scene));
}

void put_in_place(const Body& body, FilledPoints& points) {
  const Mat3 turn = rotation(body.rotation, place(body.rotation_axis));
  const Vec3 center = place(body.rotation_center), by = place(body.translation);
  points.move([&](const Vec3& at) { return Vec3(center + turn * (at - center) + by); });
}

void require_inside_grid(const Scene& scene, const FilledPoints& points) {
  const Bounds grid = grid_bounds(scene);
  const double slack = 1e-9 * scene.grid.cell;
  Index outside = 0;
  Vec3 example = Vec3::Zero();
  for (std::size_t row = 0; row < points.size(); ++row) {
    const Vec3 at = points.place(row);
    require(at.allFinite(), "point ", row,
            " has a position that is not finite: ", text_of(at, points.dimension));
    bool inside = true;
    for (int axis = 0; axis < points.dimension; ++axis) {
      inside &= at[axis] >= grid.lower[axis] - slack && at[axis] <= grid.upper[axis] + slack;
    }
    if (!inside && outside++ == 0) {
      example = at;
    }
  }
  require(outside == 0, "reaches out of the grid: ", outside, " of its ", points.size(),
          " points, the first at ", text_of(example, points.dimension), "; the grid spans ",
          text_of(scene.grid.lower), " to ", text_of(scene.grid.upper), " m");
}

/// Volumes that are masses, in another unit or of another column.
void require_room(const Scene& scene, const Body& body, const FilledPoints& points) {
  if (body.shape) {
    return;
  }
  double sum = 0.0, room = 1.0;
  for (const double volume : points.volume) {
    sum += volume;
  }
  const Vec3 size = extent(grid_bounds(scene), points.dimension);
  for (int axis = 0; axis < points.dimension; ++axis) {
    room *= size[axis];
  }
  require(sum <= (1.0 + 1e-9) * room, "its points hold ", sum, " m^", points.dimension,
          ", more than the grid's ", room, " m^", points.dimension,
          "; is the last column a volume?");
}

/// Whether conditions of heat act where points, and not the shapes of bodies, say that the surface
/// is. On a line both know it.
bool finds_surface_by_points(const Scene& scene, const Body& body) {
  const bool moves = scene.dynamics || body.motion;
  const bool all_have_shapes =
      std::ranges::all_of(scene.bodies, [](const Body& other) { return other.shape.has_value(); });
  return moves || (dimension_of(scene) > 1 && (!all_have_shapes || asks_for_points(*scene.heat)));
}

}  // namespace

int points_along_axis(const Body& body, int dimension) {
  return body.points_per_cell ? points_per_axis(*body.points_per_cell, dimension) : 2;
}

bool is_filled_in_place(const Scene& scene, const Body& body) {
  return scene.quasi_static && body.shape && is_filled_exactly(scene, body) && !body.random &&
         body.jitter == 0.0;
}

Bounds grid_bounds(const Scene& scene) {
  Bounds bounds;
  for (std::size_t axis = 0; axis < scene.grid.lower.size(); ++axis) {
    bounds.lower[static_cast<int>(axis)] = scene.grid.lower[axis];
    bounds.upper[static_cast<int>(axis)] = scene.grid.upper[axis];
  }
  return bounds;
}

int dimension_of(const Scene& scene) { return static_cast<int>(scene.grid.lower.size()); }

std::optional<Shape> placed_shape(const Body& body) {
  std::optional<Shape> placed = body.shape;
  if (placed && body.rotation != 0.0) {
    Rotated turned;
    turned.shape = *placed;
    turned.degrees = body.rotation;
    turned.center = body.rotation_center;
    turned.axis = body.rotation_axis;
    placed = Shape(turned);
  }
  if (placed && !body.translation.empty()) {
    Translated moved;
    moved.shape = *placed;
    moved.by = body.translation;
    placed = Shape(moved);
  }
  return placed;
}

BodyLattice lattice_of(const Scene& scene, const Body& body) {
  BodyLattice all;
  all.lattice.lower = place(scene.grid.lower);
  all.lattice.cell = scene.grid.cell;
  all.lattice.points_per_axis = points_along_axis(body, dimension_of(scene));
  all.options.within = grid_bounds(scene);
  if (body.rotation == 0.0) {
    // Enough to see that a body reaches out of the grid.
    const Vec3 by = place(body.translation), margin = Vec3::Constant(scene.grid.cell);
    all.options.reach = {all.options.within.lower - by - margin,
                         all.options.within.upper - by + margin};
  }
  return all;
}

bool is_filled_exactly(const Scene& scene, const Body& body) {
  if (body.fill) {
    return *body.fill == Filling::exact;
  }
  // The boxes of GIMP points keep their full width: around the centroids of pieces they no longer
  // tile the body, and fluxes and pressures on its surface stop converging (by .7 % of its area).
  const bool boxes_tile = scene.quasi_static || scene.grid.shape_function != ShapeFunction::gimp;
  const bool has_conditions =
      (scene.heat && !scene.heat->boundaries.empty() && finds_surface_by_points(scene, body)) ||
      (scene.dynamics && !scene.dynamics->boundaries.empty());
  return scene.peridynamics ? conducts_at_rest(scene) : boxes_tile || !has_conditions;
}

FilledPoints fill_body(const Scene& scene, std::size_t k) {
  const Body& body = scene.bodies[k];
  return at_place(scene, body_path(k), [&] {
    FilledPoints filled = points_of(scene, body);
    if (is_filled_elsewhere(scene, body)) {
      put_in_place(body, filled);
    }
    require_inside_grid(scene, filled);
    require_room(scene, body, filled);
    return filled;
  });
}

void require_apart(const Scene& scene, const std::vector<FilledPoints>& filled,
                   const std::vector<bool>& goes_on) {
  for (std::size_t k = 0; k < filled.size(); ++k) {
    const std::optional<Shape> shape = placed_shape(scene.bodies[k]);
    if (!shape || (!goes_on.empty() && goes_on[k])) {
      continue;
    }
    const Bounds box = bounds(*shape);
    for (std::size_t other = 0; other < filled.size(); ++other) {
      for (std::size_t row = 0; other != k && row < filled[other].size(); ++row) {
        const Vec3 at = filled[other].place(row);
        const bool has_moved = !goes_on.empty() && goes_on[other];
        const double depth = (has_moved ? 0.5 : 0.26) * filled[other].spacing;
        const bool near =
            (at.array() >= box.lower.array()).all() && (at.array() <= box.upper.array()).all();
        if (near && distance(*shape, at) <= -depth) {
          require_at(false, scene, body_path(other), "overlaps body ", k, ": its point at ",
                     text_of(at, filled[other].dimension),
                     " lies in both; cut one of them with a difference");
        }
      }
    }
  }
}

std::vector<FilledPoints> fill_bodies(const Scene& scene) {
  std::vector<FilledPoints> filled;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    filled.push_back(fill_body(scene, k));
  }
  require_apart(scene, filled);
  return filled;
}

}  // namespace lapilli
