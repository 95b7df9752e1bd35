#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/mpm/dynamics/dynamics_problem.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {

/// How far the material of each point reaches beyond it, m: half the spacing of its body, but for
/// points of the surface at the start, which may lie at any depth below it (a body off the lattice,
/// a turned or curved one), that depth. An obstacle touches a body where its surface is.
class PointSkins {
 public:
  /// `before` (may be null): the state that points go on from, which may know theirs.
  PointSkins(Points& points, const std::vector<DynamicsBody>& bodies, double cell,
             const PointStart* before);

  double of(Index row) const { return skin_[row]; }
  /// Of a point of the surface at the start the depth below the face that looks along `way_at` its
  /// place (a unit vector): at the edge of a body another face may be nearer.
  double towards(const Points& points, const DynamicsBody& body, Index row,
                 const std::function<Vec3(const Vec3&)>& way_at) const;

  void save(Archive& archive, const std::string& prefix) const;
  void load(const Archive& archive, const std::string& prefix);

 private:
  double cell_;  // m
  PointArray skin_;
};

}  // namespace lapilli
