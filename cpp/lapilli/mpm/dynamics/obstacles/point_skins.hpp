#pragma once

#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {

/// How far the material of each point reaches beyond it, m: half the spacing of its body, but for
/// points of the surface at the start, which may lie at any depth below it (a body off the lattice,
/// a turned or curved one), that depth. An obstacle touches a body where its surface is.
class PointSkins {
 public:
  /// `half_spacing` and `shapes` by body; no shapes where they are not known. `before` (may be
  /// null): the state that points go on from, which may know theirs.
  PointSkins(Points& points, const std::vector<double>& half_spacing,
             const std::vector<Shape>& shapes, const PointStart* before);

  double of(Index row) const { return skin_[row]; }

  void save(Archive& archive, const std::string& prefix) const;
  void load(const Archive& archive, const std::string& prefix);

 private:
  PointArray skin_;
};

}  // namespace lapilli
