#pragma once

#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/geometry/bounds.hpp"

namespace lapilli {

/// Ellipse in the x-y plane with its axes along x and y (turn it with `rotated`); infinite along z.
/// The distance is exact.
struct Ellipse {
  static constexpr const char* kind = "ellipse";
  std::vector<double> center = {0.0, 0.0};  // m
  std::vector<double> semi_axes;            // m, along x and y

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("center").unit("m").text("centre"), self.center);
    visit(Key("semi_axes").unit("m").required().text("half lengths along x and y"), self.semi_axes);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// Ellipsoid with its axes along x, y and z (turn it with `rotated`). The distance is exact.
struct Ellipsoid {
  static constexpr const char* kind = "ellipsoid";
  std::vector<double> center = {0.0, 0.0, 0.0};  // m
  std::vector<double> semi_axes;                 // m, along x, y and z

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("center").unit("m").text("centre"), self.center);
    visit(Key("semi_axes").unit("m").required().text("half lengths along x, y and z"),
          self.semi_axes);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

}  // namespace lapilli
