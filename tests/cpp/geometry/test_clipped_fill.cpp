#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "geometry/filled_sums.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/geometry/measure.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;
using std::numbers::pi;

namespace {

FilledPoints clipped(const Shape& shape, const Vec3& lower, double spacing, int dimension,
                     double degrees = 0.0) {
  FillOptions options;
  options.clip = true;
  options.degrees = degrees;
  return fill(shape, {lower, 2 * spacing, 2}, options, dimension);
}

// Area of the unit disk left of x = c, by the circular segment.
double disk_left_of(double c) { return pi - std::acos(c) + c * std::sqrt(1 - c * c); }

}  // namespace

TEST_CASE("a rod that ends inside boxes keeps its exact length and centroids") {
  const auto points = clipped(Box{{0.03}, {1.17}}, Vec3::Zero(), 0.25, 1);
  REQUIRE(points.size() == 5);
  REQUIRE(total(points) == Approx(1.14).epsilon(1e-15));
  REQUIRE(points.position[0] == Approx(0.14).epsilon(1e-14));
  REQUIRE(points.position[4] == Approx(1.085).epsilon(1e-14));
  const Shape two = Difference{Shape(Box{{0.03}, {1.17}}), Shape(Box{{0.3}, {0.31}})};
  REQUIRE(total(clipped(two, Vec3::Zero(), 0.25, 1)) == Approx(1.13).epsilon(1e-14));
}

TEST_CASE("straight-sided shapes are clipped exactly in any position") {
  const Shape square = Box{{-1, -1}, {1, 1}};
  for (double degrees : {0.0, 15.0, 30.0, 45.0, 71.0}) {
    const Shape turned = Rotated{square, degrees, {0.3, 0.1}};
    for (double lattice : {0.0, 20.0}) {
      const auto points = clipped(turned, Vec3(-2.03, -2.07, 0), 0.1, 2, lattice);
      REQUIRE(total(points) == Approx(4.0).epsilon(1e-13));
      const Vec3 fixed(0.3, 0.1, 0);
      const Vec3 exact = fixed + rotation(degrees, Vec3::UnitZ()) * -fixed;
      REQUIRE((centroid(points) - exact).norm() < 1e-13);
    }
  }
  const Shape corner = Polygon{{{0, 0}, {0, 2}, {1, 2}, {1, 1}, {2, 1}, {2, 0}}};
  const auto points = clipped(Translated{corner, {0.013, 0.027}}, Vec3::Zero(), 0.3, 2);
  REQUIRE(total(points) == Approx(3.0).epsilon(1e-13));
  REQUIRE((centroid(points) - Vec3(5.0 / 6 + 0.013, 5.0 / 6 + 0.027, 0)).norm() < 1e-13);
}

TEST_CASE("the clipped ring has the exact area and centroid at any spacing") {
  const Shape ring = Annulus{{0.05, 0.02}, 1, 5};
  for (double spacing : {0.5, 0.2, 0.1}) {
    const auto points = clipped(ring, Vec3(-5.5, -5.5, 0), spacing, 2);
    // 1e-8 of a box for each box on the rim.
    REQUIRE(total(points) == Approx(24 * pi).epsilon(1e-9));
    REQUIRE((centroid(points) - Vec3(0.05, 0.02, 0)).norm() < 1e-9);
    REQUIRE(*std::min_element(points.volume.begin(), points.volume.end()) >=
            1e-6 * spacing * spacing);
  }
}

TEST_CASE("one box cut by a circle has the area of the circular segment") {
  const auto outside = [](const Vec3& x) { return std::hypot(x[0], x[1]) - 1.0; };
  for (double side : {0.5, 0.1, 0.02}) {
    // The strip of the disk right of 1 - side/3, cut in boxes of `side`, upper half.
    const double from = 1.0 - side / 3;
    double sum = 0.0;
    for (int k = 0; k * side < 1.0; ++k) {
      sum += moments_inside(outside, Vec3(from, k * side, 0), side, 2).volume;
    }
    REQUIRE(sum == Approx(0.5 * (pi - disk_left_of(from))).margin(1e-8 * side * side));
  }
}

TEST_CASE("sums over clipped points converge at second order") {
  // Integral of x^2 over the unit disk: pi/4. One point at the centroid of a box misses its own
  // second moment, side^2/12 of its volume.
  const Shape disk = Disk{{0.013, 0.027}, 1.0};
  double errors[3];
  for (int level = 0; level < 3; ++level) {
    const double spacing = 0.25 / (1 << level);
    const auto error = [](const FilledPoints& points) {
      double sum = 0.0;
      for (std::size_t k = 0; k < points.size(); ++k) {
        sum += points.volume[k] * std::pow(points.position[2 * k] - 0.013, 2);
      }
      return std::abs(sum - pi / 4);
    };
    errors[level] = error(clipped(disk, Vec3(-2, -2, 0), spacing, 2));
    CAPTURE(level, errors[level]);
    // Whole boxes alone would miss pi side^2 / 12; those on the rim are smaller.
    REQUIRE(errors[level] < pi * spacing * spacing / 12);
    REQUIRE(errors[level] > 0.8 * pi * spacing * spacing / 12);
  }
  REQUIRE(std::log2(errors[0] / errors[1]) == Approx(2.0).margin(0.1));
  REQUIRE(std::log2(errors[1] / errors[2]) == Approx(2.0).margin(0.1));
}

TEST_CASE("corners made of curves are clipped to 1e-6 of a box") {
  // The lens of two unit disks one apart: 2 pi/3 - sqrt(3)/2.
  const Shape lens = Intersection{{Disk{{0, 0}, 1}, Disk{{1, 0}, 1}}};
  const double exact = 2 * pi / 3 - std::sqrt(3.0) / 2;
  for (double spacing : {0.5, 0.23, 0.11}) {
    const auto points = clipped(lens, Vec3(-0.07, -1.03, 0), spacing, 2);
    REQUIRE(total(points) == Approx(exact).margin(4e-6 * spacing * spacing));
  }
  const Shape plate = Difference{Shape(Box{{-2, -2}, {2, 2}}), Shape(Disk{{0.5, 0}, 1})};
  REQUIRE(total(clipped(plate, Vec3(-3, -3, 0), 0.25, 2)) == Approx(16 - pi).epsilon(1e-9));
}

TEST_CASE("the clipped sphere keeps volume and centroid to 1e-4 at a radius of four boxes") {
  const Shape ball = Sphere{{0.03, 0.01, -0.02}, 1.0};
  for (double spacing : {0.25, 0.125}) {
    const auto points = clipped(ball, Vec3(-2, -2, -2), spacing, 3);
    REQUIRE(total(points) == Approx(4 * pi / 3).epsilon(1e-5));
    REQUIRE((centroid(points) - Vec3(0.03, 0.01, -0.02)).norm() < 1e-5);
  }
}

TEST_CASE("plane cuts of boxes are exact in three dimensions") {
  const Shape tilted = Rotated{Shape(Box{{0, 0, 0}, {1, 1, 1}}), 30, {0.5, 0.5, 0.5}, {1, 2, 3}};
  const auto points = clipped(tilted, Vec3(-1, -1, -1), 0.25, 3);
  // A convex body with flat sides is clipped by its planes.
  REQUIRE(total(points) == Approx(1.0).epsilon(1e-13));
  REQUIRE((centroid(points) - Vec3(0.5, 0.5, 0.5)).norm() < 1e-13);
  const Vec3 normal = Vec3(1, 2, 3).normalized();
  const auto below = [&](const Vec3& x) { return normal.dot(x - Vec3(0.4, 0.5, 0.6)); };
  const auto above = [&](const Vec3& x) { return -below(x); };
  const double sum = moments_inside(below, Vec3::Zero(), 1.0, 3).volume +
                     moments_inside(above, Vec3::Zero(), 1.0, 3).volume;
  REQUIRE(sum == Approx(1.0).epsilon(1e-12));
}

// 329 a cut box are found; Illinois' rule at every step, and places between crossings, took 1,433.
TEST_CASE("boxes cut by a large sphere are measured by at most 500 distances each") {
  constexpr int reach = 21;
  long asked = 0;
  const auto outside = [&](const Vec3& x) {
    ++asked;
    return (x - Vec3(0.31, 0.17, 0.23)).norm() - 20.0;
  };
  long cut = 0;
  double volume = 0.0;
  for (int k = 0; k < 8 * reach * reach * reach; ++k) {
    const long before = asked;
    const Vec3 lower(k % (2 * reach), k / (2 * reach) % (2 * reach), k / (4 * reach * reach));
    volume += moments_inside(outside, lower - Vec3::Constant(reach), 1.0, 3).volume;
    cut += asked - before > 1 ? 1 : 0;
  }
  REQUIRE(static_cast<double>(asked) < 500.0 * static_cast<double>(cut));
  REQUIRE(volume == Approx(4.0 / 3.0 * pi * 8000.0).epsilon(1e-12));
}

TEST_CASE("slivers join a neighbour and the volume is kept") {
  // The right column is 1e-7 of a box wide.
  const double spacing = 0.25;
  const Shape box = Box{{0, 0}, {1 + 1e-7 * spacing, 1}};
  const auto points = clipped(box, Vec3::Zero(), spacing, 2);
  REQUIRE(points.size() == 16);
  REQUIRE(total(points) == Approx(1 + 1e-7 * spacing).epsilon(1e-15));
  REQUIRE((centroid(points) - Vec3(0.5 + 0.5e-7 * spacing, 0.5, 0)).norm() < 1e-15);
  FillOptions options;
  options.clip = true;
  options.smallest_volume = 0.0;
  REQUIRE(fill(box, {Vec3::Zero(), 0.5, 2}, options, 2).size() == 20);
  options.smallest_volume = 0.7;
  REQUIRE_THROWS_WITH(fill(box, {Vec3::Zero(), 0.5, 2}, options, 2),
                      Contains("smallest_volume must be 0 to 0.5 of a lattice box, got 0.7"));
}

TEST_CASE("clipped boxes come in lexicographic order and whole boxes keep their sites") {
  const auto points = clipped(Disk{{0, 0}, 1}, Vec3(-2, -2, 0), 0.25, 2);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const auto row = [&](std::size_t p) {
      return std::floor((points.position[2 * p + 1] + 2) / 0.25);
    };
    const bool next_row = row(k) > row(k - 1);
    REQUIRE((next_row || points.position[2 * k] > points.position[2 * k - 2]));
    REQUIRE(row(k) >= row(k - 1));
    if (points.volume[k] == 0.0625) {
      REQUIRE(std::remainder(points.position[2 * k] - 0.125, 0.25) == 0.0);
    }
  }
}

TEST_CASE("random points are uniform, inside, and their volumes sum to the shape's") {
  FillOptions options;
  options.random = true;
  const Shape disk = Disk{{0, 0}, 1};
  const auto points = fill(disk, {Vec3(-2, -2, 0), 0.1, 2}, options, 2);
  REQUIRE(points.size() == static_cast<std::size_t>(std::llround(pi / 0.0025)));
  REQUIRE(total(points) == Approx(pi).epsilon(1e-9));
  int inner = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double r = std::hypot(points.position[2 * k], points.position[2 * k + 1]);
    REQUIRE(r <= 1.0);
    inner += r * r < 0.5;
  }
  // Half of them within half the area; the standard deviation is sqrt(n)/2 = 18.
  REQUIRE(std::abs(inner - 628) < 80);
  REQUIRE(fill(disk, {Vec3(-2, -2, 0), 0.1, 2}, options, 2).position == points.position);
}
