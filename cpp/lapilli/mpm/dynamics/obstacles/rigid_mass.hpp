#pragma once

#include "lapilli/mpm/dynamics/obstacles/obstacle.hpp"

namespace lapilli {

/// What an obstacle that moves freely weighs.
struct RigidMass {
  double mass = 0.0;            // kg (per metre of depth in the plane)
  Vec3 center = Vec3::Zero();   // m, of mass, at the start
  Mat3 inertia = Mat3::Zero();  // kg m2, about it, at the start; in the plane zz only
};

/// From the keys of an obstacle with a mass; what they leave out is that of the shape with one
/// density. Throws std::invalid_argument, naming `where`, for a shape without an end whose centre
/// or inertia is not given.
RigidMass rigid_mass(const Obstacle& obstacle, int dimension, const std::string& where);

}  // namespace lapilli
