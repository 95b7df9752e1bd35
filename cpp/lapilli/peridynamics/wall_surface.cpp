#include "lapilli/peridynamics/wall_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/cell_list.hpp"
#include "lapilli/geometry/checks.hpp"

namespace lapilli {
namespace {

/// Gradient of a distance, by differences over a short way.
Vec3 slope(const FluidDistance& distance, const Vec3& at, int dimension, double spacing) {
  const double step = 1e-4 * spacing;
  Vec3 gradient = Vec3::Zero();
  for (int d = 0; d < dimension; ++d) {
    Vec3 ahead = at, behind = at;
    ahead[d] += step;
    behind[d] -= step;
    gradient[d] = (distance(ahead) - distance(behind)) / (2.0 * step);
  }
  return gradient;
}

/// The direction from the middle of a wall, where there is no slope, along which the fluid is
/// nearest: away from it, of length 1.
Vec3 away_from_fluid(const FluidDistance& distance, const Vec3& at, int dimension, double spacing) {
  Vec3 nearest = Vec3::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int d = 0; d < dimension; ++d) {
    for (const double sign : {1.0, -1.0}) {
      const Vec3 way = sign * Vec3::Unit(d);
      const double depth = distance(at + spacing * way);
      if (depth < least) {
        least = depth;
        nearest = -way;
      }
    }
  }
  return nearest;
}

}  // namespace

WallSurface::WallSurface(Points& points, std::vector<FluidWall> walls,
                         const FluidDistance& distance, double spacing,
                         std::vector<FluidDistance> shapes)
    : points_(points),
      walls_(std::move(walls)),
      spacing_(spacing),
      depth_(points, 1),
      normal_(points, points.dimension()),
      region_(distance),
      shapes_(std::move(shapes)) {
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
  for (Index point = 0; point < points.size(); ++point) {
    const Vec3 at = place(point);
    const int k = wall(point);
    if (k < 0) {
      if (!walls_.empty()) {
        const double outside = distance(at);
        require(outside <= tolerance, "the fluid body overlaps a wall: its point at ",
                text_of(at, points.dimension()), " lies ", outside, " m outside the fluid region");
      }
      continue;
    }
    const double depth = distance(at);
    require(depth >= -tolerance, "wall '", walls_[k].settings.name,
            "' overlaps the fluid body: its point at ", text_of(at, points.dimension()), " lies ",
            -depth, " m inside the fluid region");
    depth_[point] = std::max(0.0, depth);
    Vec3 gradient = slope(distance, at, points.dimension(), spacing);
    if (gradient.norm() <= 0.05) {
      gradient = away_from_fluid(distance, at, points.dimension(), spacing);
    }
    const double length = gradient.norm();
    for (int d = 0; d < points.dimension(); ++d) {
      normal_[point * points.dimension() + d] = -gradient[d] / length;
    }
  }
  if (shapes_.empty() && !walls_.empty()) {
    near_ = std::make_unique<CellList>(points.position(), points.dimension(), spacing);
  }
}

int WallSurface::wall_at(const Vec3& place, const Vec3& normal) const {
  for (const double ahead : {1e-3, 0.1, 0.25, 0.5, 0.75}) {
    const Vec3 there = place + ahead * spacing_ * normal;
    for (std::size_t k = 0; k < shapes_.size(); ++k) {
      if (shapes_[k](there) <= 0.0) {
        return static_cast<int>(k);
      }
    }
  }
  int found = -1;
  if (near_) {
    double nearest = 1e300;
    near_->each_within(place + 0.5 * spacing_ * normal, 0.8 * spacing_,
                       [&](Index other, double squared) {
                         if (wall(other) >= 0 && squared < nearest) {
                           nearest = squared;
                           found = wall(other);
                         }
                       });
  }
  return found;
}

Vec3 WallSurface::place(Index point) const {
  Vec3 at = Vec3::Zero();
  for (int d = 0; d < points_.dimension(); ++d) {
    at[d] = points_.position()[point * points_.dimension() + d];
  }
  return at;
}

WallSurface::Behind WallSurface::behind(Index point, double reach, const CellList& near) const {
  Vec3 inward = Vec3::Zero();
  for (int d = 0; d < points_.dimension(); ++d) {
    inward[d] = -normal(point)[d];
  }
  Behind found{depth_[point], std::numeric_limits<double>::infinity()};
  const Vec3 from = place(point);
  for (double way = 0.5 * spacing_; way <= 2.0 * reach; way += 0.5 * spacing_) {
    const Vec3 at = from + way * inward;
    if (const double outside = region_ ? region_(at) : 0.0; outside < -0.1 * spacing_) {
      found.to_fluid = depth_[point] + way + outside;
      break;
    }
    near.each_within(at, 0.75 * spacing_, [&](Index other, double) {
      if (wall(other) >= 0) {
        found.filled = std::max(found.filled, depth_[point] + inward.dot(place(other) - from));
      }
    });
  }
  return found;
}

void WallSurface::require_thickness(double horizon) const {
  // A fluid point a spacing off the surface must find the wall filled to its horizon. The walls
  // that it meets count together: how far they go along the normal of each surface point. A wall
  // between fluid and fluid is as thick for each of them as its half.
  const double needed = horizon - 1.05 * spacing_;
  const CellList near(points_.position(), points_.dimension(), spacing_);
  double filled = needed, to_fluid = 2.0 * needed + 0.95 * spacing_;
  Index least_filled = -1, nearest_fluid = -1;
  for (Index point = 0; point < points_.size(); ++point) {
    if (wall(point) < 0 || depth_[point] >= 0.99 * spacing_) {
      continue;
    }
    const Behind found = behind(point, horizon, near);
    if (found.to_fluid < to_fluid) {
      to_fluid = found.to_fluid;
      nearest_fluid = point;
    } else if (found.filled < filled) {
      filled = found.filled;
      least_filled = point;
    }
  }
  const auto where = [&](Index point, double thickness) {
    return message("wall '", walls_[wall(point)].settings.name, "' is about ", thickness,
                   " m thick at ", text_of(place(point), points_.dimension()));
  };
  if (nearest_fluid >= 0) {
    const double layers = std::ceil((2.0 * needed + spacing_) / spacing_ - 0.05);
    require(false, where(nearest_fluid, to_fluid),
            " with fluid on both sides, which points feel through it within their horizon of ",
            horizon, " m: give it at least ", layers, " layers (", layers * spacing_,
            " m), or take a smaller grid.cell");
  }
  if (least_filled >= 0) {
    require(false, where(least_filled, filled + 0.5 * spacing_), ", thinner than the horizon of ",
            horizon, " m: give it at least ", std::ceil(horizon / spacing_ - 0.5), " layers");
  }
}

void WallSurface::require_closed(const FluidDistance& distance) const {
  const CellList near(points_.position(), points_.dimension(), spacing_);
  for (Index point = 0; point < points_.size(); ++point) {
    const Vec3 at = place(point);
    const double outside = wall(point) < 0 ? distance(at) : -spacing_;
    if (outside < -0.75 * spacing_) {
      continue;  // a wall, or well inside
    }
    const Vec3 gradient = slope(distance, at, points_.dimension(), spacing_);
    const double length = gradient.norm();
    const Vec3 behind = length > 0.05 ? Vec3(at + (spacing_ - outside) / length * gradient) : at;
    if (distance(behind) < 0.5 * spacing_) {
      continue;  // bodies touch here
    }
    double first = 2.0 * spacing_;
    near.each_within(behind, 1.05 * spacing_, [&](Index other, double) {
      first = wall(other) >= 0 ? std::min(first, depth_[other]) : first;
    });
    require(first < 1.4 * spacing_, "no wall holds the fluid at ", text_of(at, points_.dimension()),
            ", ", std::abs(outside),
            " m from its surface: close the flow with walls, free surfaces are ", "not modelled");
  }
}

void WallSurface::save(Archive& archive) const {
  archive.write("walls/depth", depth_.values());
  archive.write("walls/normal", normal_.values());
}

void WallSurface::load(const Archive& archive) {
  archive.read("walls/depth", depth_.values());
  archive.read("walls/normal", normal_.values());
}

}  // namespace lapilli
