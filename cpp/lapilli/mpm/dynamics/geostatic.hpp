#pragma once

#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/vector.hpp"
#include "lapilli/materials/symmetric_tensor.hpp"

namespace lapilli {

/// The stress of a body at rest: under the weight of all bodies above, or below an even free
/// surface that is given, level or inclined (an infinite slope).
struct GeostaticStress {
  std::vector<double> surface;  // m, a place on the free surface; empty: all bodies above weigh
  std::vector<double> normal;   // outward; need not be of unit length; empty: against gravity
  double k0 = 0.5;              // stress along the surface over stress across it
  double surcharge = 0.0;       // Pa, that rests on the surface

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("surface").unit("m").length(0, 3).text(
              "a place on an even free surface; empty: the weight of all bodies above, level by "
              "level"),
          self.surface);
    visit(Key("normal").length(0, 3).text("outward normal of the surface; empty: against gravity"),
          self.normal);
    visit(Key("k0").non_negative().text("stress along the surface over the one across it"),
          self.k0);
    visit(Key("surcharge")
              .unit("Pa")
              .non_negative()
              .text("load on the surface that the stress at the start bears too"),
          self.surcharge);
  }
};

/// The stress at a place, Pa: on a plane parallel to the surface at depth d the weight above,
/// sigma n = density d gravity and the surcharge along gravity; above the surface the latter alone.
SymmetricTensor stress_at(const GeostaticStress& rest, const Vec3& place, const Vec3& gravity,
                          double density);

/// The stress under a weight per area of a level plane, Pa, and the surcharge.
SymmetricTensor stress_under(const GeostaticStress& rest, double weight, const Vec3& gravity);

}  // namespace lapilli
