#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/random_points.hpp"
#include "lapilli/geometry/clip.hpp"

using namespace lapilli;

namespace {

const Vec<2> low(1.0, 2.0), high(1.5, 2.5);

double first(const Vec<2>& x) { return 1 + 2 * x[0] - x[1] + x[0] * x[1] + 3 * x[1] * x[1]; }

template <int Dim, class Function>
double integral(const std::vector<QuadraturePoint<Dim>>& points, const Function& f) {
  double sum = 0.0;
  for (const auto& point : points) {
    sum += point.weight * f(point.position);
  }
  return sum;
}

}  // namespace

TEST_CASE("a cell cut once leaves triangles, trapezia and pentagons of known area and centroid") {
  const auto cell = rectangle(low, high);
  REQUIRE(moments(cell).size == Approx(0.25).epsilon(1e-15));
  // Triangle at the lower left corner with legs 0.1 and 0.2.
  const Cut<2> corner{{2.0, 1.0}, 2.0 * 1.0 + 2.2};
  const Moments<2> triangle = moments(clip_polygon(cell, std::array{corner}));
  REQUIRE(triangle.size == Approx(0.01).epsilon(1e-13));
  REQUIRE(triangle.centroid[0] == Approx(1.0 + 0.1 / 3).epsilon(1e-14));
  REQUIRE(triangle.centroid[1] == Approx(2.0 + 0.2 / 3).epsilon(1e-14));
  // Its complement: areas and first moments add up to the cell's.
  const Cut<2> other{-corner.normal, -corner.offset};
  const Outline left = clip_polygon(cell, std::array{other});
  REQUIRE(left.size() == 5);
  const Moments<2> pentagon = moments(left);
  REQUIRE(pentagon.size + triangle.size == Approx(0.25).epsilon(1e-15));
  const Vec<2> whole = pentagon.size * pentagon.centroid + triangle.size * triangle.centroid;
  REQUIRE((whole / 0.25 - 0.5 * (low + high)).norm() < 1e-14);
}

TEST_CASE("cuts through corners, along edges and past the cell") {
  const auto cell = rectangle({0, 0}, {1, 1});
  const auto left = [&](const Cut<2>& cut) {
    return moments(clip_polygon(cell, std::array{cut})).size;
  };
  REQUIRE(left({{1, 1}, 1}) == 0.5);
  REQUIRE(left({{1, 0}, 1}) == 1.0);
  REQUIRE(left({{1, 0}, 0}) == 0.0);
  REQUIRE(left({{1, 0}, -1}) == 0.0);
  REQUIRE(left({{0, 5}, 50}) == 1.0);
  REQUIRE(left({{1, 0}, 1e-12}) == Approx(1e-12).epsilon(1e-14));
}

TEST_CASE("many cuts of a cell: both sides of each cut always make up what was there") {
  Random random(3);
  for (int trial = 0; trial < 500; ++trial) {
    Outline polygon = rectangle(low, high);
    Polyhedron body = cuboid(Vec3(1, 2, 3), Vec3(1.5, 2.5, 3.5));
    for (int k = 0; k < 4; ++k) {
      Vec3 normal, through;
      for (int axis = 0; axis < 3; ++axis) {
        normal[axis] = random.uniform(-1, 1);
        through[axis] = axis + 1 + random.uniform(0, 0.5);
      }
      const Cut<3> cut = cut_through<3>(through, normal);
      const Cut<3> back{-cut.normal, -cut.offset};
      const double whole = moments(body).size;
      const Polyhedron one = clip_polyhedron(body, std::array{cut});
      const Polyhedron two = clip_polyhedron(body, std::array{back});
      REQUIRE(moments(one).size + moments(two).size == Approx(whole).epsilon(1e-13).margin(1e-17));
      body = moments(one).size > moments(two).size ? one : two;

      const Cut<2> flat = cut_through<2>(through.head<2>(), normal.head<2>());
      const double area = moments(polygon).size;
      const Outline kept = clip_polygon(polygon, std::array{flat});
      const Outline rest = clip_polygon(polygon, std::array{Cut<2>{-flat.normal, -flat.offset}});
      REQUIRE(moments(kept).size + moments(rest).size == Approx(area).epsilon(1e-13).margin(1e-17));
      polygon = moments(kept).size > moments(rest).size ? kept : rest;
    }
  }
}

TEST_CASE("a corner cut off a box is a tetrahedron of known volume and centroid") {
  const auto box = cuboid(Vec3(1, 2, 3), Vec3(2, 3, 4));
  REQUIRE(moments(box).size == Approx(1.0).epsilon(1e-15));
  // Plane through (1.2, 2, 3), (1, 2.5, 3), (1, 2, 3.25).
  const Vec3 normal(5, 2, 4);
  const Cut<3> cut = cut_through<3>(Vec3(1.2, 2, 3), normal);
  const Moments<3> tip = moments(clip_polyhedron(box, std::array{cut}));
  REQUIRE(tip.size == Approx(0.2 * 0.5 * 0.25 / 6).epsilon(1e-13));
  REQUIRE((tip.centroid - Vec3(1.05, 2.125, 3.0625)).norm() < 1e-14);
  REQUIRE(clip_polyhedron(box, std::array{Cut<3>{{1, 0, 0}, 1}}).empty());
  REQUIRE(moments(clip_polyhedron(box, std::array{Cut<3>{{1, 0, 0}, 2}})).size == Approx(1.0));
  REQUIRE(moments(clip_polyhedron(box, std::array{cut_through<3>({1, 2, 3}, {1, -1, 0})})).size ==
          Approx(0.5).epsilon(1e-15));
  // A plane through three corners.
  REQUIRE(moments(clip_polyhedron(box, std::array{cut_through<3>({2, 2, 3}, {1, 1, 1})})).size ==
          Approx(1.0 / 6).epsilon(1e-15));
}

TEST_CASE("quadrature integrates quadratic functions over clipped cells exactly") {
  // Halves of the unit square by y <= x: integral of x^a y^b = 1 / ((b + 1) (a + b + 2)).
  const Outline half = clip_polygon(rectangle({0, 0}, {1, 1}), std::array{Cut<2>{{-1, 1}, 0}});
  const auto monomial = [](double a, double b) { return 1 / ((b + 1) * (a + b + 2)); };
  const double exact =
      monomial(0, 0) + 2 * monomial(1, 0) - monomial(0, 1) + monomial(1, 1) + 3 * monomial(0, 2);
  REQUIRE(integral<2>(quadrature(half), first) == Approx(exact).epsilon(1e-14));
  // The corner tetrahedron x + y + z <= 1: x^2 gives 2!/5! = 1/60, x y gives 1/120.
  const auto tip = clip_polyhedron(cuboid({0, 0, 0}, {1, 1, 1}), std::array{Cut<3>{{1, 1, 1}, 1}});
  const auto points = quadrature(tetrahedra(tip));
  REQUIRE(points.size() >= 4);
  REQUIRE(integral<3>(points, [](const Vec3& x) { return x[0] * x[0]; }) ==
          Approx(1.0 / 60).epsilon(1e-13));
  REQUIRE(integral<3>(points, [](const Vec3& x) { return x[0] * x[1]; }) ==
          Approx(1.0 / 120).epsilon(1e-13));
  REQUIRE(integral<3>(points, [](const Vec3&) { return 1.0; }) == Approx(1.0 / 6).epsilon(1e-14));
}

TEST_CASE("area and centroid of an outline that is not convex, and far away") {
  const Outline corner = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  REQUIRE(moments(corner).size == 3.0);
  REQUIRE((moments(corner).centroid - Vec<2>(5.0 / 6, 5.0 / 6)).norm() < 1e-15);
  // Cut in two separate parts: x + y >= 2.5 keeps two triangles of area 1/8.
  const auto parts = clip_polygon(corner, std::array{Cut<2>{{-1, -1}, -2.5}});
  REQUIRE(moments(parts).size == Approx(0.25).epsilon(1e-14));
  REQUIRE(moments(rectangle({1e8, 1e8}, {1e8 + 0.5, 1e8 + 0.5})).size == 0.25);
}
