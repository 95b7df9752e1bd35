#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"

namespace lapilli {

/// Turning about a fixed axis at a constant rate.
struct Rotation {
  static constexpr const char* kind = "rotation";
  double revolutions_per_second = 0.0;      // 1/s, positive counter-clockwise
  std::vector<double> center;               // m; empty: the origin
  std::vector<double> axis{0.0, 0.0, 1.0};  // 3D only; need not be of unit length

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("revolutions_per_second").unit("1/s").required().text("positive counter-clockwise"),
          self.revolutions_per_second);
    visit(Key("center").unit("m").length(0, 3).text("a place on the axis; empty: the origin"),
          self.center);
    visit(Key("axis").length(3, 3).text("direction of the axis, in 3D"), self.axis);
  }
};

/// Motion along a straight line at a constant velocity.
struct Translation {
  static constexpr const char* kind = "translation";
  std::vector<double> velocity;  // m/s

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("velocity").unit("m/s").required().length(1, 3).text("one number an axis"),
          self.velocity);
  }
};

/// A velocity that shears the points about a centre, u_theta = r w (1 + s (1 - r^2/R^2)): a disc of
/// radius R stays a disc. For tests of moving points with an exact answer.
struct Swirl {
  static constexpr const char* kind = "swirl";
  double revolutions_per_second = 0.0;  // 1/s, at the rim
  double shear = 0.4;                   // s
  double radius = 1.0;                  // m
  std::vector<double> center;           // m; empty: the origin

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("revolutions_per_second").unit("1/s").required().text("of the rim"),
          self.revolutions_per_second);
    visit(Key("shear").text("s of w (1 + s (1 - r^2/R^2))"), self.shear);
    visit(Key("radius").unit("m").positive().text("R, the rim"), self.radius);
    visit(Key("center").unit("m").length(0, 3).text("centre of the swirl; empty: the origin"),
          self.center);
  }
};

using Motion = std::variant<Rotation, Translation, Swirl>;

/// Moves the points of bodies as prescribed, exactly: places are computed from those at the start,
/// so that no error accumulates. Points of bodies without a motion rest.
template <int Dim>
class PrescribedMotion final : public Physics {
 public:
  /// `motions` by body; an empty one rests. Throws std::invalid_argument for a motion that the
  /// dimension does not allow. `lazy`: points are moved only where somebody may look; for scenes
  /// whose physics does not ask where they are.
  PrescribedMotion(Points& points, std::vector<std::optional<Motion>> motions, bool lazy = false);

  std::string name() const override { return "motion"; }
  StepLimit step_limit() const override;
  StepReport advance(const Step& step) override;
  void refresh_output() override;
  std::vector<Field> fields() override { return {}; }
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;

 private:
  /// Call body(number, begin, end) for runs of rows of one body.
  template <class Body>
  void for_each_run(const Body& body) const;
  /// Move the points from their places at one time to those at another.
  void move(double from, double to);

  Points& points_;
  std::vector<std::optional<Motion>> motions_;
  PointArray start_;  // m, places at time zero
  bool lazy_;
  double time_ = 0.0, placed_ = 0.0;  // s, now and where the points are
};

}  // namespace lapilli
