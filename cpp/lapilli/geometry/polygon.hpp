#pragma once

#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/geometry/bounds.hpp"

namespace lapilli {

/// Polygon in the x-y plane, convex or not, vertices in either sense of rotation; infinite along z.
/// The distance is exact (time proportional to the vertices). Holes: use a difference.
struct Polygon {
  static constexpr const char* kind = "polygon";
  std::vector<std::vector<double>> vertices;  // m, at least 3 pairs

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("vertices").unit("m").required().text("corners in order, the last joins the first"),
          self.vertices);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  /// Throws std::invalid_argument naming the edges where the outline crosses or touches itself.
  void check(int dimension) const;
};

}  // namespace lapilli
