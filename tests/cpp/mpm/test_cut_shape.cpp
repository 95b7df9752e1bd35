#include "lapilli/mpm/surface/cut_shape.hpp"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <numbers>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/random.hpp"

namespace lapilli {
namespace {

constexpr double pi = std::numbers::pi;

struct Found {
  double volume = 0.0, area = 0.0;
  Vec3 closure = Vec3::Zero();  // integral of the normal
};

template <int Dim>
Found measure(const Shape& shape, ShapeFunction function, double half_extent) {
  check(shape, Dim);
  const double edge = std::ceil(half_extent) + 2.0;
  const Grid<Dim> grid(Vec<Dim>::Constant(-edge), Vec<Dim>::Constant(edge), 1.0);
  const CubeLayout layout(function);
  const double cube = std::pow(1.0 / layout.per_axis, Dim);
  Found found;
  for (const CellCut<Dim>& cell : cut_shape<Dim>(shape, grid, layout)) {
    found.volume += cube * std::popcount(cell.full);
    for (const auto& point : cell.points) {
      found.volume += point.weight;
    }
    for (const auto& piece : cell.pieces) {
      found.area += piece.area();
      found.closure.head<Dim>() += piece.area() * piece.normal;
    }
  }
  return found;
}

Shape placed(Shape shape, double degrees, std::vector<double> by) {
  Rotated turned;
  turned.shape = std::move(shape);
  turned.degrees = degrees;
  Translated moved;
  moved.shape = Shape(turned);
  moved.by = std::move(by);
  return Shape(moved);
}

const ShapeFunction functions[] = {ShapeFunction::linear, ShapeFunction::gimp,
                                   ShapeFunction::bspline};

TEST_CASE("Flat shapes anywhere on the grid have their volume and surface") {
  Random random(3);
  const Shape box = Box{{-2.6, -1.7}, {2.6, 1.7}};
  const Shape l_shape = Polygon{{{-3, -3}, {3, -3}, {3, -0.5}, {0, -0.5}, {0, 3}, {-3, 3}}};
  const Shape wedge = Polygon{{{-5, 0}, {5, 0}, {5, 10 * std::tan(15.0 * pi / 180.0)}}};
  const Shape plate = Box{{-4.0, -0.1}, {4.0, 0.1}};
  struct Case {
    Shape shape;
    double volume, area;
  };
  const double leg = 10 * std::tan(15.0 * pi / 180.0);
  const Case cases[] = {{box, 5.2 * 3.4, 17.2},
                        {l_shape, 36 - 3 * 3.5, 24},
                        {wedge, 5 * leg, 10 + leg + std::hypot(10, leg)},
                        {plate, 1.6, 16.4}};
  for (const Case& one : cases) {
    for (int draw = 0; draw < 12; ++draw) {
      const double angle = draw == 0 ? 0.0 : random.uniform(0.0, 360.0);
      const std::vector<double> by = {random.uniform(), random.uniform()};
      for (const ShapeFunction function : functions) {
        const Found found = measure<2>(placed(one.shape, angle, by), function, 7.0);
        INFO(kind_of(one.shape) << " at " << angle << " degrees, " << by[0] << " " << by[1]
                                << ", functions " << name_of(function));
        // Where more than two sheets meet in a part of a cell the cut is rough.
        CHECK(found.volume == Approx(one.volume).epsilon(2e-3));
        CHECK(found.area == Approx(one.area).epsilon(4e-3));
        CHECK(found.closure.norm() <= 4e-3 * one.area);
      }
    }
  }
}

TEST_CASE("A box that ends on cubes of the grid is measured exactly") {
  for (const double side : {1.0, 1.5, 2.25, 3.0}) {
    for (const ShapeFunction function : functions) {
      const Found square = measure<2>(Shape(Box{{-1, 0}, {-1 + side, side}}), function, 4.0);
      CHECK(square.volume == Approx(side * side).epsilon(1e-12));
      CHECK(square.area == Approx(4 * side).epsilon(1e-8));
      const Found cube = measure<3>(Shape(Box{{-1, 0, 0}, {-1 + side, side, side}}), function, 4.0);
      CHECK(cube.volume == Approx(side * side * side).epsilon(1e-12));
      CHECK(cube.area == Approx(6 * side * side).epsilon(1e-8));
      const Found rod = measure<1>(Shape(Box{{-1}, {-1 + side}}), function, 4.0);
      CHECK(rod.volume == Approx(side).epsilon(1e-12));
      CHECK(rod.area == 2.0);
    }
  }
}

TEST_CASE("Round shapes converge at second order and better") {
  for (const ShapeFunction function : functions) {
    for (const double radius : {3.0, 10.0, 40.0}) {
      const Found disk = measure<2>(Shape(Disk{{0.31, 0.17}, radius}), function, radius + 1);
      INFO(name_of(function) << ", disk of " << radius << " cells: " << disk.volume << " "
                             << disk.area);
      const double share = 0.05 / (radius * radius) + 1e-5;
      CHECK(disk.volume == Approx(pi * radius * radius).epsilon(share));
      CHECK(disk.area == Approx(2 * pi * radius).epsilon(share));
    }
    for (const double radius : {2.5, 5.0, 10.0}) {
      const Found ball =
          measure<3>(Shape(Sphere{{0.31, 0.17, 0.41}, radius}), function, radius + 1);
      INFO(name_of(function) << ", ball of " << radius << " cells: " << ball.volume << " "
                             << ball.area);
      const double share = 0.05 / (radius * radius);
      CHECK(ball.volume == Approx(4 * pi / 3 * std::pow(radius, 3)).epsilon(share));
      CHECK(ball.area == Approx(4 * pi * radius * radius).epsilon(share));
    }
  }
}

TEST_CASE("Curves that touch lines of the grid have their surface once") {
  // Radii and centres on quarters of cells: every disk touches faces of cubes, as do circles a
  // rounding error or a ten-millionth beside them.
  Random random(11);
  for (int trial = 0; trial < 120; ++trial) {
    const auto quarter = [&](double low, double high) {
      return 0.25 * std::round(4.0 * random.uniform(low, high));
    };
    const double radius = quarter(3.0, 12.0);
    const double beside = trial % 3 == 0 ? 0.0 : trial % 3 == 1 ? 1e-15 : 1e-7;
    const std::vector<double> center{quarter(-2.0, 2.0) + beside, quarter(-2.0, 2.0) - beside};
    const auto function =
        std::array{ShapeFunction::linear, ShapeFunction::gimp,
                   ShapeFunction::bspline}[static_cast<std::size_t>(random.uniform(0.0, 3.0))];
    Shape shape = Disk{center, radius};
    if (trial % 4 == 1) {
      shape = Ellipse{center, {radius, radius}};
    }
    const Found found = measure<2>(shape, function, radius + 2.5);
    CAPTURE(trial, radius, center[0], center[1]);
    REQUIRE(found.area == Approx(2.0 * pi * radius).epsilon(3e-4 / radius));
    REQUIRE(found.volume == Approx(pi * radius * radius).epsilon(1e-3 / radius));
    // Found 1e-5: caps that reach into a cube by a ten-millionth, and chords of their arcs.
    REQUIRE(found.closure.norm() < 3e-5);
  }
}

TEST_CASE("Holes, unions and turned cubes") {
  const Shape annulus = Annulus{{0.3, 0.1}, 1.2, 4.7};
  const Shape touching = Union{{Shape(Box{{-3, -1}, {0, 1}}), Shape(Box{{0, -1}, {3, 1}})}};
  Difference bored;
  bored.shape = Shape(Box{{-4, -4}, {4, 4}});
  bored.minus = Shape(Disk{{0.2, -0.1}, 2.0});
  for (const ShapeFunction function : functions) {
    const Found ring = measure<2>(annulus, function, 6.0);
    CHECK(ring.volume == Approx(pi * (4.7 * 4.7 - 1.2 * 1.2)).epsilon(5e-4));
    CHECK(ring.area == Approx(2 * pi * 5.9).epsilon(5e-4));
    const Found bar = measure<2>(touching, function, 5.0);
    CHECK(bar.volume == Approx(12.0).epsilon(1e-6));
    CHECK(bar.area == Approx(16.0).epsilon(1e-2));  // its seam lies on the lattice of cubes
    const Found plate = measure<2>(Shape(bored), function, 5.0);
    CHECK(plate.volume == Approx(64 - 4 * pi).epsilon(5e-4));
    CHECK(plate.area == Approx(32 + 4 * pi).epsilon(5e-4));
    Rotated cube;
    cube.shape = Shape(Box{{-2.5, -2.5, -2.5}, {2.5, 2.5, 2.5}});
    cube.degrees = 31.0;
    cube.axis = {1.0, 2.0, 0.5};
    const Found turned = measure<3>(Shape(cube), function, 5.0);
    INFO(name_of(function) << ": " << turned.volume << " " << turned.area);
    CHECK(turned.volume == Approx(125.0).epsilon(2e-3));
    CHECK(turned.area == Approx(150.0).epsilon(3e-3));
    const Found pipe =
        measure<3>(Shape(Cylinder{{0.2, 0.1, -3.0}, {0.2, 0.4, 3.0}, 2.0}), function, 5.0);
    const double length = std::hypot(6.0, 0.3);
    INFO("cylinder " << pipe.volume << " " << pipe.area);
    CHECK(pipe.volume == Approx(4 * pi * length).epsilon(1e-2));
    CHECK(pipe.area == Approx(4 * pi * length + 8 * pi).epsilon(1e-2));
  }
}

}  // namespace
}  // namespace lapilli
