#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/random_points.hpp"
#include "lapilli/geometry/shape.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;

namespace {

// Points at which each shape is asked; its surface crosses this box.
const Bounds around{Vec3(-3, -3, -3), Vec3(3, 3, 3)};

std::vector<Shape> planar_shapes() {
  return {Box{{-1, -0.5}, {1.5, 1}},
          HalfSpace{{0.3, 0.2}, {1, 2}},
          Disk{{0.2, -0.1}, 1.5},
          Annulus{{0.1, 0.2}, 0.7, 1.9},
          Polygon{{{-1, -1}, {2, -1}, {2, 1.5}, {0.5, 0.25}, {-1.5, 2}}},
          Rotated{Shape(Box{{-1, -0.5}, {1.5, 1}}), 33.0, {0.2, 0.1}},
          Translated{Shape(Annulus{{0, 0}, 0.7, 1.9}), {0.4, -0.2}}};
}

std::vector<Shape> solid_shapes() {
  return {Box{{-1, -0.5, -2}, {1.5, 1, 0.5}}, HalfSpace{{0.3, 0.2, 1}, {1, 2, -1}},
          Sphere{{0.1, 0.2, 0.3}, 1.7}, Cylinder{{-1, -1, 0}, {1, 0.5, 1}, 0.8},
          Rotated{Shape(Cylinder{{-1, 0, 0}, {1, 0, 0}, 0.8}), 50.0, {0, 0.2, 0}, {1, 1, 1}}};
}

std::vector<Shape> combined_shapes() {
  return {Union{{Disk{{0, 0}, 1.2}, Box{{0, 0}, {2, 2}}}},
          Intersection{{Disk{{0, 0}, 1.2}, Box{{0, 0}, {2, 2}}}},
          Difference{Shape(Box{{-2, -2}, {2, 2}}), Shape(Disk{{0.5, 0}, 1})}};
}

}  // namespace

TEST_CASE("distance is that to the nearest point of the surface, exact shapes") {
  for (int dimension : {2, 3}) {
    for (const Shape& shape : dimension == 2 ? planar_shapes() : solid_shapes()) {
      INFO(kind_of(shape) << " in " << dimension << " dimensions");
      check(shape, dimension);
      for (const Vec3& x : random_points(300, dimension, around)) {
        const double d = distance(shape, x);
        const Vec3 n = gradient(shape, x);
        REQUIRE(n.norm() == Approx(1.0).epsilon(1e-12));
        // The foot of the normal is on the surface, so the distance is at most |d| ...
        REQUIRE(std::abs(distance(shape, x - d * n)) < 1e-12);
        // ... and no point nearer than |d| has the other sign, so it is at least |d|.
        for (const Vec3& direction : random_points(20, dimension, around)) {
          const Vec3 near = x + 0.999 * std::abs(d) * direction.normalized();
          REQUIRE((distance(shape, near) > 0) == (d > 0));
        }
      }
    }
  }
}

TEST_CASE("distance of combined shapes has the right sign and at most the true size") {
  for (const Shape& shape : combined_shapes()) {
    INFO(kind_of(shape));
    check(shape, 2);
    for (const Vec3& x : random_points(300, 2, around)) {
      const double d = distance(shape, x);
      for (const Vec3& direction : random_points(20, 2, around)) {
        const Vec3 near = x + 0.999 * std::abs(d) * direction.normalized();
        REQUIRE((distance(shape, near) > 0) == (d > 0));
      }
      REQUIRE(std::abs(distance(shape, project(shape, x))) < 1e-9);
    }
  }
  const Vec3 both(0.5, 0.5, 0), disk_only(-0.5, 0, 0), box_only(1.5, 1.5, 0);
  const auto shapes = combined_shapes();
  REQUIRE(covers(shapes[0], both));
  REQUIRE(covers(shapes[0], disk_only));
  REQUIRE(covers(shapes[0], box_only));
  REQUIRE(covers(shapes[1], both));
  REQUIRE_FALSE(covers(shapes[1], disk_only));
  REQUIRE_FALSE(covers(shapes[1], box_only));
  REQUIRE_FALSE(covers(shapes[2], both));
  REQUIRE(covers(shapes[2], box_only));
}

TEST_CASE("gradient is the slope of the distance") {
  const double step = 1e-6;
  for (const Shape& shape : solid_shapes()) {
    INFO(kind_of(shape));
    int agreeing = 0;
    const auto points = random_points(200, 3, around);
    for (const Vec3& x : points) {
      Vec3 slope;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 e = step * Vec3::Unit(axis);
        slope[axis] = (distance(shape, x + e) - distance(shape, x - e)) / (2 * step);
      }
      agreeing += (slope - gradient(shape, x)).norm() < 1e-6;
    }
    // Off the medial axis, which no random point comes within a step of but by chance.
    REQUIRE(agreeing >= static_cast<int>(points.size()) - 1);
  }
}

TEST_CASE("bounds hold the shape and touch it") {
  for (int dimension : {2, 3}) {
    for (const Shape& shape : dimension == 2 ? planar_shapes() : solid_shapes()) {
      INFO(kind_of(shape));
      const Bounds box = bounds(shape);
      for (const Vec3& x : random_points(3000, dimension, around)) {
        if (covers(shape, x)) {
          REQUIRE((x.array() >= box.lower.array()).all());
          REQUIRE((x.array() <= box.upper.array()).all());
        }
      }
    }
  }
  const Bounds tilted = bounds(Rotated{Shape(Box{{-1, -1}, {1, 1}}), 45.0, {}});
  REQUIRE(tilted.upper[0] == Approx(std::sqrt(2.0)));
  const Bounds cylinder = bounds(Cylinder{{0, 0, 0}, {0, 0, 2}, 0.5});
  REQUIRE(cylinder.upper == Vec3(0.5, 0.5, 2));
  const Bounds wall = bounds(HalfSpace{{0, 2}, {0, -3}});
  REQUIRE(wall.lower[1] == 2.0);
  REQUIRE(std::isinf(wall.upper[1]));
}

TEST_CASE("an interval in one dimension") {
  const Shape rod = Box{{0.0}, {1.5}};
  check(rod, 1);
  REQUIRE(distance(rod, Vec3(0.5, 0, 0)) == -0.5);
  REQUIRE(distance(rod, Vec3(-2, 0, 0)) == 2.0);
  REQUIRE(gradient(rod, Vec3(1.4, 0, 0)) == Vec3(1, 0, 0));
}

TEST_CASE("a region selects surface with slack") {
  const Shape region = Box{{0, 0}, {1, 1}};
  REQUIRE(covers(region, Vec3(1.05, 0.5, 0), 0.1));
  REQUIRE_FALSE(covers(region, Vec3(1.15, 0.5, 0), 0.1));
  REQUIRE(covers(region, Vec3(1, 1, 0)));
}

TEST_CASE("a polygon ends at its vertices and knows its outside however it is drawn") {
  const Polygon square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
      clockwise{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};
  for (const Polygon& one : {square, clockwise}) {
    CHECK(one.distance({4, 5, 0}) == Approx(5));
    CHECK(one.distance({-3, 0.5, 0}) == Approx(3));
    CHECK(one.gradient({1, 0.5, 0}).isApprox(Vec3(1, 0, 0)));  // on the outline itself
    CHECK(one.gradient({0.5, 0, 0}).isApprox(Vec3(0, -1, 0)));
  }
}

TEST_CASE("rotation by right angles is exact") {
  REQUIRE(rotation(90, Vec3::UnitZ()) * Vec3(1, 0, 0) == Vec3(0, 1, 0));
  REQUIRE(rotation(-270, Vec3(0, 0, 5)) * Vec3(1, 0, 0) == Vec3(0, 1, 0));
  REQUIRE((rotation(30, Vec3(1, 2, 3)) * Vec3(1, 2, 3) - Vec3(1, 2, 3)).norm() < 1e-15);
}

TEST_CASE("unusable shapes are refused with what was given and what is allowed") {
  const auto refused = [](const Shape& shape, int dimension, const std::string& text) {
    REQUIRE_THROWS_WITH(check(shape, dimension), Contains(text));
  };
  refused(Box{{0, 0}, {1}}, 2, "as many numbers");
  refused(Box{{0, 0, 0}, {1, 1, 1}}, 2, "lower needs 1 to 2 numbers, got 3");
  refused(Box{{0, 2}, {1, 1}}, 2,
          "lower must be below upper along every axis, got (0, 2) and (1, 1)");
  refused(HalfSpace{{0, 0}, {0, 0}}, 2, "normal must not be zero");
  refused(Disk{{0, 0}, -1}, 2, "disk: radius must be positive and finite, got -1");
  refused(Disk{{0}, 1}, 2, "disk: center needs 2 numbers, got 1");
  refused(Disk{{0, std::nan("")}, 1}, 2, "disk: center must be finite");
  refused(Disk{{0, 0}, 1}, 1, "disk needs a grid of 2 or 3 dimensions, this one has 1: use a box");
  refused(Annulus{{0, 0}, 2, 1}, 2, "inner must be smaller than outer, got 2 and 1");
  refused(Sphere{{0, 0, 0}, 1}, 2,
          "sphere needs a grid of 3 dimensions, this one has 2: use a disk");
  refused(Sphere{{0, 0, 0}, 0}, 3, "sphere: radius must be positive");
  refused(Cylinder{{0, 0, 1}, {0, 0, 1}, 1}, 3, "start and end must differ, both are (0, 0, 1)");
  refused(Polygon{{{0, 0}, {1, 0}}}, 2, "at least 3 vertices are needed, got 2");
  refused(Polygon{{{0, 0}, {1, 0}, {1}}}, 2, "polygon: vertex 2 needs 2 numbers, got 1");
  refused(Polygon{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}}, 2,
          "vertices 3 and 0 are the same point (0, 0)");
  refused(Polygon{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}, 2,
          "edge 0 from (0, 0) to (1, 1) meets edge 2 from (1, 0) to (0, 1)");
  refused(Polygon{{{0, 0}, {2, 0}, {1, 0}, {1, 1}}}, 2,
          "edge 0 from (0, 0) to (2, 0) meets edge 1");
  refused(Polygon{{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}}, 2, "crosses or touches itself");
  refused(Union{}, 2, "union: shapes needs at least one shape");
  refused(Difference{Shape(Disk{{0, 0}, 1}), {}}, 2, "difference: minus must be given");
  refused(Difference{Shape(Disk{{0, 0}, 1}), Shape(Disk{{0, 0}, -1})}, 2, "disk: radius");
  refused(Rotated{Shape(Disk{{0, 0}, 1}), 30, {}, {1, 0, 0}}, 2,
          "the axis is (0, 0, 1), got (1, 0, 0)");
  refused(Rotated{{}, 30, {}}, 2, "rotated: shape must be given");
  refused(Translated{Shape(Disk{{0, 0}, 1}), {}}, 2, "translated: by needs 1 or 2 numbers, got 0");
}
