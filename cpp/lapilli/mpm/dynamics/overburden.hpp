#pragma once

#include <vector>

#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// Length of a ray inside a checked shape, from a place along a unit direction, as far as it runs
/// within `room`, m. Gaps thinner than 1e-4 of the way are missed.
double length_inside(const Shape& shape, const Vec3& from, const Vec3& direction,
                     const Bounds& room);

/// The weight of all bodies above a place.
class Overburden {
 public:
  struct Layer {
    Shape shape;
    double density;  // kg/m^3
  };
  /// Throws std::invalid_argument without gravity (m/s^2).
  Overburden(std::vector<Layer> layers, const Vec3& gravity, const Bounds& room);

  /// Weight per area of a level plane, Pa.
  double at(const Vec3& place) const;

 private:
  std::vector<Layer> layers_;
  Vec3 up_;
  double gravity_;  // m/s^2
  Bounds room_;
};

}  // namespace lapilli
