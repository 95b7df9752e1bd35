#pragma once

#include <vector>

#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {

/// How far a body reaches beyond a node, from the mean position of its points weighed with the
/// shape function of the node: exact for rows of points along a flat face. Voids, corners and what
/// lies farther away do not tell, since the weights cancel.
class SurfaceDepth {
 public:
  /// `half_width` of the points' boxes and `spacing` of the points, in cells.
  SurfaceDepth(ShapeFunction shape, double half_width, double spacing);

  /// `mean`: from the node along the outward normal, in cells. The surface lies so far from it.
  double operator()(double mean) const;

 private:
  static constexpr int entries = 512;
  std::vector<double> depth_;  // over equal steps of the mean position
};

}  // namespace lapilli
