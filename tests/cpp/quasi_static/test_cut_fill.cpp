// Few points that integrate the gradients of linear shape functions exactly over cut cells in
// space.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "lapilli/geometry/cell_fill.hpp"
#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

struct Sums {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

Sums sums_of(const FilledPoints& points) {
  Sums sums;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 at = Eigen::Map<const Vec3>(points.position.data() + 3 * k);
    CHECK(points.volume[k] > 0.0);
    sums.volume += points.volume[k];
    sums.first += points.volume[k] * at;
    sums.second += points.volume[k] * at * at.transpose();
  }
  return sums;
}

const Lattice lattice{Vec3(-6.2, -6.3, -6.4), 1.0, 2};

}  // namespace

TEST_CASE("a sphere takes at most 1.3 times the points asked for") {
  for (const int per_axis : {2, 3}) {
    for (const double radius : {5.0, 3.1}) {
      const Sphere ball{{0.13, 0.21, 0.34}, radius};
      const FilledPoints points =
          fill_cells(ball, Lattice{lattice.lower, lattice.cell, per_axis}, {}, 3);
      const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3);
      const double asked = volume * std::pow(per_axis, 3);
      INFO(points.size() << " points for " << asked);
      CHECK(static_cast<double>(points.size()) < 1.3 * asked);
      CHECK(sums_of(points).volume == Approx(volume).epsilon(3e-4));
    }
  }
}

TEST_CASE("a turned box keeps its volume, first and second moments to rounding") {
  const Vec3 size(6.1, 4.7, 3.3), axis(0.3, 0.5, 0.81), low(-2.1, -1.7, -1.3);
  const Shape box = Rotated{
      Shape(Box{{low[0], low[1], low[2]}, {low[0] + size[0], low[1] + size[1], low[2] + size[2]}}),
      37.0,
      {0.0, 0.0, 0.0},
      {axis[0], axis[1], axis[2]}};
  const Mat3 turn = Eigen::AngleAxisd(37.0 * std::numbers::pi / 180.0, axis.normalized()).matrix();
  const Vec3 middle = turn * (low + 0.5 * size);
  for (const int per_axis : {1, 2, 3}) {
    const Sums sums = sums_of(fill_cells(box, Lattice{lattice.lower, 1.0, per_axis}, {}, 3));
    CHECK(sums.volume == Approx(size.prod()).epsilon(1e-12));
    CHECK((sums.first - size.prod() * middle).norm() < 1e-11 * size.prod());
    // Cells that are not cut hold their lattice, which has the mixed moments of the cell about its
    // middle (none), but not its squares: compare what gradients see.
    const Mat3 exact =
        size.prod() * (turn * (size.cwiseAbs2() / 12.0).asDiagonal() * turn.transpose() +
                       middle * middle.transpose());
    for (int i = 0; i < 3; ++i) {
      CHECK(sums.second(i, (i + 1) % 3) == Approx(exact(i, (i + 1) % 3)).epsilon(1e-11));
    }
  }
}

TEST_CASE("points of cut cells lie in their cells") {
  // Slivers of any thickness: a corner of a turned half space.
  for (const double off : {1e-3, 1e-2, 0.1, 0.5, 1.1, 1.6}) {
    const Shape wedge =
        Intersection{{Box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}},
                      HalfSpace{{off / 3.0, off / 3.0, off / 3.0}, {1.0, 0.9, 1.1}}}};
    const FilledPoints points = fill_cells(wedge, Lattice{Vec3::Zero(), 1.0, 2}, {}, 3);
    for (const double coordinate : points.position) {
      CHECK(coordinate > 0.0);
      CHECK(coordinate < 1.0);
    }
  }
}
