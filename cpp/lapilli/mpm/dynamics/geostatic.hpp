#pragma once

#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/vector.hpp"
#include "lapilli/materials/symmetric_tensor.hpp"

namespace lapilli {

/// The stress of a body that rests under its own weight below an even free surface, level or
/// inclined (an infinite slope).
struct GeostaticStress {
  std::vector<double> surface;  // m, a place on the free surface
  std::vector<double> normal;   // outward; need not be of unit length; empty: against gravity
  double k0 = 0.5;              // stress along the surface over stress across it

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("surface").unit("m").required().length(2, 3).text("a place on the free surface"),
          self.surface);
    visit(Key("normal").length(0, 3).text("outward normal of the surface; empty: against gravity"),
          self.normal);
    visit(Key("k0").non_negative().text("stress along the surface over the one across it"),
          self.k0);
  }
};

/// The stress at a place, Pa: on a plane parallel to the surface at depth d the weight above,
/// sigma n = density d gravity; zero above the surface.
SymmetricTensor stress_at(const GeostaticStress& rest, const Vec3& place, const Vec3& gravity,
                          double density);

}  // namespace lapilli
