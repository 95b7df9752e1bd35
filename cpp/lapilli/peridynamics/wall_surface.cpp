#include "lapilli/peridynamics/wall_surface.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

Vec3 place_of(const Points& points, Index point) {
  Vec3 place = Vec3::Zero();
  for (int d = 0; d < points.dimension(); ++d) {
    place[d] = points.position()[point * points.dimension() + d];
  }
  return place;
}

std::string text_of(const Vec3& place) {
  return message("(", place[0], ", ", place[1], ", ", place[2], ")");
}

}  // namespace

WallSurface::WallSurface(Points& points, std::vector<Wall> walls, const FluidDistance& distance,
                         double spacing)
    : points_(points),
      walls_(std::move(walls)),
      spacing_(spacing),
      depth_(points, 1),
      normal_(points, points.dimension()) {
  Index bodies = 0;
  for (const Index body : points.body()) {
    bodies = std::max(bodies, body + 1);
  }
  wall_of_body_.assign(static_cast<std::size_t>(bodies), -1);
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    const int body = walls_[k].body;
    require(body >= 0 && body < bodies && wall_of_body_[body] < 0, "wall '",
            walls_[k].settings.name, "' needs a body of its own with points, got body ", body,
            " of ", bodies);
    wall_of_body_[body] = static_cast<int>(k);
  }
  // The share of a spacing by which a lattice point may lie on the wrong side of a curved surface.
  const double tolerance = 0.3 * spacing;
  const double step = 1e-4 * spacing;
  for (Index point = 0; point < points.size(); ++point) {
    const Vec3 place = place_of(points, point);
    const int k = wall(point);
    if (k < 0) {
      if (!walls_.empty()) {
        const double outside = distance(place);
        require(outside <= tolerance, "the fluid body overlaps a wall: its point at ",
                text_of(place), " lies ", outside, " m outside the fluid region");
      }
      continue;
    }
    const double depth = distance(place);
    require(depth >= -tolerance, "wall '", walls_[k].settings.name,
            "' overlaps the fluid body: its point at ", text_of(place), " lies ", -depth,
            " m inside the fluid region");
    depth_[point] = std::max(0.0, depth);
    Vec3 gradient = Vec3::Zero();
    for (int d = 0; d < points.dimension(); ++d) {
      Vec3 ahead = place, behind = place;
      ahead[d] += step;
      behind[d] -= step;
      gradient[d] = distance(ahead) - distance(behind);
    }
    const double length = gradient.norm();
    require(length > 0.1 * step, "the distance from the fluid region has no slope at ",
            text_of(place), " in wall '", walls_[k].settings.name, "'");
    for (int d = 0; d < points.dimension(); ++d) {
      normal_[point * points.dimension() + d] = -gradient[d] / length;
    }
  }
}

void WallSurface::require_thickness(double horizon) const {
  std::vector<double> deepest(walls_.size(), 0.0);
  for (Index point = 0; point < points_.size(); ++point) {
    if (const int k = wall(point); k >= 0) {
      deepest[k] = std::max(deepest[k], depth_[point]);
    }
  }
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    // A fluid point a spacing off the surface must find the wall filled to its horizon.
    require(deepest[k] + 1.05 * spacing_ >= horizon, "wall '", walls_[k].settings.name,
            "' is about ", deepest[k] + 0.5 * spacing_, " m thick, thinner than the horizon of ",
            horizon, " m: give it at least ", std::ceil(horizon / spacing_ - 0.5), " layers");
  }
}

}  // namespace lapilli
