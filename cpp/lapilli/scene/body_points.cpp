#include "lapilli/scene/body_points.hpp"

#include <cmath>

#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/sources.hpp"
#include "lapilli/mpm/quasi_static/cut_fill.hpp"
#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/scene_file.hpp"

namespace lapilli {
namespace {

std::string body_path(std::size_t index) { return element_path("bodies", index); }

int points_along_axis(const Body& body, int dimension) {
  return body.points_per_cell ? points_per_axis(*body.points_per_cell, dimension) : 2;
}

/// Implicit solvers want points that integrate cut cells exactly: the shape is filled where it
/// stands, cell by cell of the grid.
bool is_filled_in_place(const Scene& scene, const Body& body) {
  return scene.quasi_static && body.clip && body.shape;
}

FilledPoints filled_shape(const Scene& scene, const Body& body) {
  const int dimension = dimension_of(scene);
  Lattice lattice;
  lattice.lower = place(scene.grid.lower);
  lattice.cell = scene.grid.cell;
  lattice.points_per_axis = points_along_axis(body, dimension);
  if (is_filled_in_place(scene, body)) {
    return fill_exactly(*placed_shape(body), lattice, dimension);
  }
  FillOptions options;
  options.clip = body.clip;
  options.jitter = body.jitter;
  options.random = body.random;
  options.seed = static_cast<std::uint64_t>(body.seed);
  options.within = grid_bounds(scene);
  return fill(*body.shape, lattice, options, dimension);
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
  return body.shape ? filled_shape(scene, body)
         : has_file ? points_of_file(scene, body)
                    : given_points(scene, body);
}

bool is_placed(const Body& body) { return body.rotation != 0.0 || !body.translation.empty(); }

void put_in_place(const Body& body, FilledPoints& points) {
  const Mat3 turn = rotation(body.rotation, place(body.rotation_axis));
  const Vec3 center = place(body.rotation_center), by = place(body.translation);
  for (std::size_t row = 0; row < points.size(); ++row) {
    Vec3 at = Vec3::Zero();
    double* coordinates = points.position.data() + row * points.dimension;
    std::copy(coordinates, coordinates + points.dimension, at.data());
    at = center + turn * (at - center) + by;
    std::copy(at.data(), at.data() + points.dimension, coordinates);
  }
}

Vec3 position_of(const FilledPoints& points, std::size_t row) {
  Vec3 at = Vec3::Zero();
  for (int axis = 0; axis < points.dimension; ++axis) {
    at[axis] = points.position[row * points.dimension + axis];
  }
  return at;
}

void require_inside_grid(const Scene& scene, const FilledPoints& points) {
  const Bounds grid = grid_bounds(scene);
  const double slack = 1e-9 * scene.grid.cell;
  Index outside = 0;
  Vec3 example = Vec3::Zero();
  for (std::size_t row = 0; row < points.size(); ++row) {
    const Vec3 at = position_of(points, row);
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

// A point deep inside another body's shape means that two bodies claim the same place.
void require_apart(const Scene& scene, const std::vector<FilledPoints>& filled) {
  for (std::size_t k = 0; k < filled.size(); ++k) {
    const std::optional<Shape> shape = placed_shape(scene.bodies[k]);
    if (!shape) {
      continue;
    }
    const Bounds box = bounds(*shape);
    for (std::size_t other = 0; other < filled.size(); ++other) {
      for (std::size_t row = 0; other != k && row < filled[other].size(); ++row) {
        const Vec3 at = position_of(filled[other], row);
        const double depth = 0.26 * filled[other].spacing;
        const bool near =
            (at.array() >= box.lower.array()).all() && (at.array() <= box.upper.array()).all();
        require_at(!near || distance(*shape, at) > -depth, scene, body_path(other),
                   "overlaps body ", k, ": its point at ", text_of(at, filled[other].dimension),
                   " lies in both; cut one of them with a difference");
      }
    }
  }
}

}  // namespace

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
  if (!body.shape || !is_placed(body)) {
    return body.shape;
  }
  Rotated turned;
  turned.shape = *body.shape;
  turned.degrees = body.rotation;
  turned.center = body.rotation_center;
  turned.axis = body.rotation_axis;
  Translated moved;
  moved.shape = Shape(turned);
  moved.by = body.translation;
  return Shape(moved);
}

std::vector<FilledPoints> fill_bodies(const Scene& scene) {
  std::vector<FilledPoints> filled;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    at_place(scene, body_path(k), [&] {
      filled.push_back(points_of(scene, body));
      if (is_placed(body) && !is_filled_in_place(scene, body)) {
        put_in_place(body, filled.back());
      }
      require_inside_grid(scene, filled.back());
    });
  }
  require_apart(scene, filled);
  return filled;
}

}  // namespace lapilli
