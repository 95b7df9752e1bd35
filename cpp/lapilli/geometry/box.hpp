#pragma once

#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/geometry/bounds.hpp"

namespace lapilli {

/// Interval, rectangle or box with sides along the axes. Axes beyond the given numbers are
/// unbounded. The distance is exact.
struct Box {
  static constexpr const char* kind = "box";
  std::vector<double> lower;  // m, 1 to 3 numbers
  std::vector<double> upper;  // m, as many

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("lower").unit("m").required().text("corner with the least coordinates"), self.lower);
    visit(Key("upper").unit("m").required().text("corner with the largest coordinates"),
          self.upper);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// Everything on one side of a plane (a line in two dimensions): the side the normal points away
/// from is inside. The distance is exact; the normal need not have length 1.
struct HalfSpace {
  static constexpr const char* kind = "half-space";
  std::vector<double> point;   // m
  std::vector<double> normal;  // pointing out

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("point").unit("m").required().text("any point of the plane"), self.point);
    visit(Key("normal").required().text("direction pointing out of the half-space"), self.normal);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

}  // namespace lapilli
