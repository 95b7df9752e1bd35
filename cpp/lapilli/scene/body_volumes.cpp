#include "lapilli/scene/body_volumes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/pair_entries.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/geometry/shape_volume.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/resolve_files.hpp"

namespace lapilli {
namespace {

// Points this near to the volume of their shape, as a share, are taken for it.
constexpr double allowed_share = 1e-3;

double volume_of_shape(const Scene& scene, const Body& body) {
  const auto [lattice, options] = lattice_of(scene, body);
  return volume_of(*body.shape, lattice, options, dimension_of(scene));
}

std::vector<BodyVolume> volumes_of_points(const Scene& scene, const Points& points) {
  std::vector<BodyVolume> all;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    all.push_back({name_or_number(scene.bodies[k].name, k), 0, 0.0, {}});
  }
  for (Index row = 0; row < points.size(); ++row) {
    const auto body = static_cast<std::size_t>(points.body()[static_cast<std::size_t>(row)]);
    if (body < all.size()) {  // what follows are walls
      ++all[body].points;
      all[body].volume += points.volume()[static_cast<std::size_t>(row)];
    }
  }
  return all;
}

// Points whose volumes exceed the box around them by this factor are packed too densely.
constexpr double most_packed = 1.5;

/// The box around the points of a body, and what they hold.
struct PointBox {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 upper = -lower;
  double volume = 0.0;  // m^dimension
  Index points = 0;

  /// Around the points' own boxes, taken as equal.
  double room(int dimension) const {
    const double spacing = std::pow(volume / static_cast<double>(points), 1.0 / dimension);
    double product = 1.0;
    for (int axis = 0; axis < dimension; ++axis) {
      product *= upper[axis] - lower[axis] + spacing;
    }
    return product;
  }
};

PointBox box_of(const Points& points, Index body) {
  PointBox box;
  const auto dimension = static_cast<std::size_t>(points.dimension());
  for (std::size_t row = 0; row < static_cast<std::size_t>(points.size()); ++row) {
    if (points.body()[row] != body) {
      continue;
    }
    ++box.points;
    box.volume += points.volume()[row];
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      const double at = points.position()[row * dimension + axis];
      box.lower[static_cast<int>(axis)] = std::min(box.lower[static_cast<int>(axis)], at);
      box.upper[static_cast<int>(axis)] = std::max(box.upper[static_cast<int>(axis)], at);
    }
  }
  return box;
}

}  // namespace

std::vector<BodyVolume> body_volumes(const Scene& as_written, const Points& points) {
  const Scene scene = with_resolved_files(as_written);
  std::vector<BodyVolume> all = volumes_of_points(scene, points);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (scene.bodies[k].shape) {
      all[k].of_shape = volume_of_shape(scene, scene.bodies[k]);
    }
  }
  return all;
}

std::vector<BodyVolume> body_volumes_at_start(const Scene& as_written, const Points& points) {
  const Scene scene = with_resolved_files(as_written);
  std::vector<BodyVolume> all = volumes_of_points(scene, points);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Body& body = scene.bodies[k];
    if (body.shape) {
      const bool is_sum_of_parts = is_filled_exactly(scene, body) || body.random;
      all[k].of_shape = is_sum_of_parts ? all[k].volume : volume_of_shape(scene, body);
    }
  }
  return all;
}

std::vector<Note> packing_warnings(const Scene& scene, const Points& points) {
  const int dimension = points.dimension();
  std::vector<Note> all;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    if (body.shape) {
      continue;
    }
    const PointBox box = box_of(points, static_cast<Index>(k));
    if (box.volume > most_packed * box.room(dimension)) {
      all.push_back(note("bodies.packed-points", "the points of ", name_or_number(body.name, k),
                         " hold ", box.volume, " m^", dimension, ", the box around them ",
                         box.room(dimension),
                         ": their volumes overlap; are they in another unit?"));
    }
  }
  return all;
}

std::vector<Note> volume_warnings(const std::vector<BodyVolume>& volumes, int dimension) {
  constexpr const char* sizes[] = {"length", "area", "volume"};
  std::vector<Note> all;
  for (const BodyVolume& body : volumes) {
    const double share = body.of_shape ? body.volume / *body.of_shape - 1.0 : 0.0;
    if (std::abs(share) > allowed_share) {
      all.push_back(note("bodies.volume", "the points of ", body.name, " hold ",
                         0.01 * std::round(1e4 * std::abs(share)), " % ",
                         share > 0.0 ? "more" : "less", " ", sizes[dimension - 1],
                         " than its shape: set fill = \"exact\", or choose smaller cells"));
    }
  }
  return all;
}

}  // namespace lapilli
