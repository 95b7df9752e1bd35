#include "lapilli/mpm/dynamics/obstacles/point_skins.hpp"

#include "lapilli/core/parallel.hpp"

namespace lapilli {

PointSkins::PointSkins(Points& points, const std::vector<double>& half_spacing,
                       const std::vector<Shape>& shapes, const PointStart* before)
    : skin_(points, 1) {
  const int dimension = points.dimension();
  parallel_for(points.size(), [&](Index row) {
    const auto body = static_cast<std::size_t>(points.body()[row]);
    skin_[row] = half_spacing[body];
    if (shapes.empty()) {
      return;
    }
    Vec3 place = Vec3::Zero();
    for (int axis = 0; axis < dimension; ++axis) {
      place[axis] = points.position()[row * dimension + axis];
    }
    const double depth = -distance(shapes[body], place);
    if (depth > 0.0 && depth < 2.0 * half_spacing[body]) {
      skin_[row] = depth;
    }
  });
  const std::string known = "dynamics/obstacles/skins";
  if (before != nullptr && before->state && before->state->contains(known)) {
    before->fetch(known, points, skin_);
  }
}

void PointSkins::save(Archive& archive, const std::string& prefix) const {
  archive.write(prefix + "/skins", skin_.values());
}

void PointSkins::load(const Archive& archive, const std::string& prefix) {
  archive.read(prefix + "/skins", skin_.values());
}

}  // namespace lapilli
