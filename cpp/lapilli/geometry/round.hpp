#pragma once

#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/geometry/bounds.hpp"

namespace lapilli {

/// Disk in the x-y plane; infinite along z. The distance is exact.
struct Disk {
  static constexpr const char* kind = "disk";
  std::vector<double> center = {0.0, 0.0};  // m
  double radius = 1.0;                      // m

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("center").unit("m").text("centre"), self.center);
    visit(Key("radius").unit("m").positive().required().text("radius"), self.radius);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// Ring between two circles in the x-y plane; infinite along z. The distance is exact.
struct Annulus {
  static constexpr const char* kind = "annulus";
  std::vector<double> center = {0.0, 0.0};  // m
  double inner = 0.5;                       // m
  double outer = 1.0;                       // m

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("center").unit("m").text("centre"), self.center);
    visit(Key("inner").unit("m").positive().required().text("radius of the hole"), self.inner);
    visit(Key("outer").unit("m").positive().required().text("radius of the rim"), self.outer);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// Ball. The distance is exact.
struct Sphere {
  static constexpr const char* kind = "sphere";
  std::vector<double> center = {0.0, 0.0, 0.0};  // m
  double radius = 1.0;                           // m

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("center").unit("m").text("centre"), self.center);
    visit(Key("radius").unit("m").positive().required().text("radius"), self.radius);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// Cylinder with flat ends around the segment from start to end. The distance is exact.
struct Cylinder {
  static constexpr const char* kind = "cylinder";
  std::vector<double> start;  // m, centre of one end
  std::vector<double> end;    // m, centre of the other end
  double radius = 1.0;        // m

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("start").unit("m").required().text("centre of one end"), self.start);
    visit(Key("end").unit("m").required().text("centre of the other end"), self.end);
    visit(Key("radius").unit("m").positive().required().text("radius"), self.radius);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

}  // namespace lapilli
