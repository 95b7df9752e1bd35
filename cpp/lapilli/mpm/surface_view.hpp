#pragma once

#include <vector>

namespace lapilli {

/// The nodes of a surface that boundary laws act on, to look at. A node that two laws share is
/// there once for each.
struct SurfaceView {
  int dimension = 0;
  std::vector<double> position;  // m, rows x dimension: the node projected to the surface
  std::vector<double> normal;    // outward, rows x dimension
  std::vector<double> area;      // m^(dimension - 1), rows
};

/// A physics with laws on the surface of its bodies.
class HasSurface {
 public:
  virtual ~HasSurface() = default;
  /// The surface of the last step; of the start before the first one.
  virtual SurfaceView surface() const = 0;
};

}  // namespace lapilli
