#pragma once

#include <memory>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/geometry/bounds.hpp"

namespace lapilli {

struct Shape;

/// A shape held by another one: a value that is copied by reference and never changed. Empty until
/// given.
class Nested {
 public:
  Nested() = default;
  Nested(Shape shape);  // NOLINT: a shape is given where a nested one is asked for

  bool empty() const { return shape_ == nullptr; }
  const Shape& operator*() const { return *shape_; }
  const Shape* operator->() const { return shape_.get(); }

 private:
  std::shared_ptr<const Shape> shape_;
};

/// What lies in any of the shapes. Distance: exact outside, at most the true depth inside.
struct Union {
  static constexpr const char* kind = "union";
  std::vector<Shape> shapes;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("shapes").required().text("shapes that are joined"), self.shapes);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// What lies in all of the shapes. Distance: exact inside, at most the true distance outside.
struct Intersection {
  static constexpr const char* kind = "intersection";
  std::vector<Shape> shapes;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("shapes").required().text("shapes whose common part is taken"), self.shapes);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// What lies in `shape` and not in `minus`. The distance has the right sign and at most the true
/// size.
struct Difference {
  static constexpr const char* kind = "difference";
  Nested shape;
  Nested minus;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("shape").required().text("shape that is cut"), self.shape);
    visit(Key("minus").required().text("shape that is taken away"), self.minus);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// A shape turned about an axis through `center` by the right-hand rule; in two dimensions
/// counter-clockwise. Distances are those of the shape.
struct Rotated {
  static constexpr const char* kind = "rotated";
  Nested shape;
  double degrees = 0.0;                        // counter-clockwise
  std::vector<double> center;                  // m; empty: the origin
  std::vector<double> axis = {0.0, 0.0, 1.0};  // three dimensions only

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("shape").required().text("shape that is turned"), self.shape);
    visit(Key("degrees").unit("degree").required().text("angle, counter-clockwise"), self.degrees);
    visit(Key("center").unit("m").text("point that stays; empty: the origin"), self.center);
    visit(Key("axis").text("direction that stays, in three dimensions"), self.axis);
  }

  /// The turn as a matrix.
  Mat3 matrix() const;
  /// Where `x` was before the turn.
  Vec3 before(const Vec3& x) const;
  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// A shape moved without turning. Distances are those of the shape.
struct Translated {
  static constexpr const char* kind = "translated";
  Nested shape;
  std::vector<double> by;  // m

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("shape").required().text("shape that is moved"), self.shape);
    visit(Key("by").unit("m").required().text("displacement"), self.by);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

/// Rotation by `degrees` about `axis` (any length but zero); exact for multiples of 90 degrees
/// about a coordinate axis.
Mat3 rotation(double degrees, const Vec3& axis);

}  // namespace lapilli
