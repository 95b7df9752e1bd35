#pragma once

#include <cstddef>
#include <vector>

namespace lapilli {

/// The nodes of a surface that boundary laws act on, to look at. A node that two laws share is
/// there once for each.
struct SurfaceView {
  int dimension = 0;
  std::vector<double> position;  // m, rows x dimension: the node projected to the surface
  std::vector<double> normal;    // outward, rows x dimension
  std::vector<double> area;      // m^(dimension - 1), rows

  /// Add the nodes of one law, which hold vectors `position`, `normal` and `area`.
  template <class Nodes>
  void append(const Nodes& nodes) {
    for (std::size_t k = 0; k < nodes.area.size(); ++k) {
      position.insert(position.end(), nodes.position[k].data(),
                      nodes.position[k].data() + dimension);
      normal.insert(normal.end(), nodes.normal[k].data(), nodes.normal[k].data() + dimension);
    }
    area.insert(area.end(), nodes.area.begin(), nodes.area.end());
  }
};

/// A physics with laws on the surface of its bodies.
class HasSurface {
 public:
  virtual ~HasSurface() = default;
  /// The surface of the last step; of the start before the first one.
  virtual SurfaceView surface() const = 0;
};

}  // namespace lapilli
