#include "lapilli/mpm/dynamics/obstacles/point_skins.hpp"

#include <algorithm>
#include <utility>

#include "lapilli/core/parallel.hpp"

namespace lapilli {

namespace {

/// Half the spacing of the points of a body, m.
double half_spacing(const DynamicsBody& body, double cell) { return body.half_width * cell; }

Vec3 place_of(const Points& points, Index row) {
  Vec3 place = Vec3::Zero();
  for (int axis = 0; axis < points.dimension(); ++axis) {
    place[axis] = points.position()[row * points.dimension() + axis];
  }
  return place;
}

}  // namespace

PointSkins::PointSkins(Points& points, const std::vector<DynamicsBody>& bodies, double cell,
                       const PointStart* before)
    : cell_(cell), skin_(points, 1) {
  parallel_for(points.size(), [&](Index row) {
    const DynamicsBody& body = bodies[static_cast<std::size_t>(points.body()[row])];
    skin_[row] = half_spacing(body, cell);
    if (body.shape) {
      const double depth = -distance(*body.shape, place_of(points, row));
      if (depth > 0.0 && depth < 2.0 * skin_[row]) {
        skin_[row] = depth;
      }
    }
  });
  const std::string known = "dynamics/obstacles/skins";
  if (before != nullptr && before->state && before->state->contains(known)) {
    before->fetch(known, points, skin_);
  }
}

double PointSkins::towards(const Points& points, const DynamicsBody& body, Index row,
                           const std::function<Vec3(const Vec3&)>& way_at) const {
  constexpr double aligned = 0.95, at_a_corner = 0.8, near = 1e-6;
  constexpr int most_steps = 30;
  const double spacing = 2.0 * half_spacing(body, cell_);
  const Vec3 place = place_of(points, row);
  if (!body.shape || -distance(*body.shape, place) >= spacing) {
    return skin_[row];
  }
  const Vec3 way = way_at(place);
  if (gradient(*body.shape, place).dot(way) > at_a_corner) {
    return skin_[row];  // one face, perhaps a round one, which turns as it rolls
  }
  double depth = skin_[row];
  for (int step = 0; step < most_steps && depth < spacing; ++step) {
    const Vec3 at = place + depth * way;
    const double left = -distance(*body.shape, at);
    if (left < near * spacing) {
      return gradient(*body.shape, at).dot(way) > aligned ? depth : skin_[row];
    }
    depth += left;
  }
  return skin_[row];
}

void PointSkins::save(Archive& archive, const std::string& prefix) const {
  archive.write(prefix + "/skins", skin_.values());
}

void PointSkins::load(const Archive& archive, const std::string& prefix) {
  archive.read(prefix + "/skins", skin_.values());
}

}  // namespace lapilli
