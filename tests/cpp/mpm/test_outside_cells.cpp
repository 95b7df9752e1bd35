#include <catch2/catch.hpp>

#include "lapilli/mpm/surface/nodal_surface.hpp"
#include "mpm/point_sets.hpp"

namespace lapilli {
namespace {

using scenes::Layout;
using scenes::scatter;

const Grid<2> grid(Vec<2>::Constant(-8.0), Vec<2>::Constant(8.0), 1.0);

bool is_outside(const OutsideCells<2>& cells, double x, double y) {
  return cells.flags()[grid.cell_index(grid.cell_containing(Vec<2>(x, y)))] != 0;
}

Index inside_count(const OutsideCells<2>& cells) {
  return std::count(cells.flags().begin(), cells.flags().end(), 0);
}

TEST_CASE("The hole of a ring is outside, and stays so when the ring moves") {
  for (const double hole : {1.0, 2.0, 3.0}) {
    const auto inside = [&](const Vec<2>& y) { return y.norm() > hole && y.norm() < 5.0; };
    auto points = scatter<2>(Vec<2>(0.5, 0.5), 5.0, 0.5, {}, inside);
    const DistanceFunction distance = [&](const Vec3& x) {
      const double r = (x.head<2>() - Vec<2>(0.5, 0.5)).norm();
      return std::max(hole - r, r - 5.0);
    };
    OutsideCells<2> cells(grid, 1);
    cells.start(*points, distance);
    CHECK(is_outside(cells, 0.5, 0.5));
    CHECK_FALSE(is_outside(cells, 4.5, 0.5));
    CHECK(is_outside(cells, 7.5, 0.5));
    for (int step = 0; step < 8; ++step) {
      for (Index row = 0; row < points->size(); ++row) {
        points->position()[2 * row] += 0.25;
      }
      points->moved();
      cells.follow(*points);
    }
    if (hole >= 2.0) {  // a hole of one cell may close as it crosses the grid
      CHECK(is_outside(cells, 2.5, 0.5));
    }
    CHECK(is_outside(cells, -4.5, 0.5));
    CHECK_FALSE(is_outside(cells, 6.5, 0.5));
  }
}

TEST_CASE("A pore of one cell is outside where the shape says so and not where a fill missed it") {
  const auto inside = [](const Vec<2>& y) {
    return y.cwiseAbs().maxCoeff() < 4.0 && !(y - Vec<2>(0.5, 0.5)).isZero(0.5);
  };
  auto points = scatter<2>(Vec<2>::Zero(), 5.0, 0.5, {}, [](const Vec<2>& y) {
    return y.cwiseAbs().maxCoeff() < 4.0 && (y - Vec<2>(0.5, 0.5)).cwiseAbs().maxCoeff() > 0.5;
  });
  OutsideCells<2> cells(grid, 1);
  cells.start(*points, [&](const Vec3& x) { return inside(x.head<2>()) ? -0.1 : 0.1; });
  CHECK(is_outside(cells, 0.5, 0.5));
  cells.start(*points, [](const Vec3& x) { return x.head<2>().cwiseAbs().maxCoeff() - 4.0; });
  CHECK_FALSE(is_outside(cells, 0.5, 0.5));
  cells.start(*points, {});
  CHECK_FALSE(is_outside(cells, 0.5, 0.5));
}

TEST_CASE("Two bodies one cell apart are not glued") {
  Points points(2);
  const auto box = [](const Vec<2>& y) { return y.cwiseAbs().maxCoeff() < 2.0; };
  scenes::append<2>(points, Vec<2>(-3.0, 0.0), 2.0, 0.5, {}, box, 0);
  scenes::append<2>(points, Vec<2>(2.0, 0.0), 2.0, 0.5, {}, box, 1);
  OutsideCells<2> cells(grid, 2);
  cells.start(points, {});
  CHECK(is_outside(cells, -0.5, 0.5));
  cells.follow(points);
  CHECK(is_outside(cells, -0.5, 0.5));
  CHECK(inside_count(cells) == 32);
}

TEST_CASE("Cells that open between points as they move apart are not outside") {
  auto points = scatter<2>(Vec<2>::Zero(), 3.0, 0.5, {}, [](const Vec<2>&) { return true; });
  OutsideCells<2> cells(grid, 1);
  cells.start(*points, {});
  CHECK(inside_count(cells) == 36);
  for (double& x : points->position()) {
    x *= 2.3;  // spacing 1.15 cells: one row of cells in eight is empty
  }
  points->moved();
  cells.follow(*points);
  for (double x = -5.5; x < 6.0; x += 1.0) {
    for (double y = -5.5; y < 6.0; y += 1.0) {
      CHECK_FALSE(is_outside(cells, x, y));
    }
  }
  CHECK(is_outside(cells, 7.5, 0.5));
}

TEST_CASE("One point a cell, turned: the cells that a lattice misses are not outside") {
  for (const double angle : {10.0, 20.0, 30.0, 45.0}) {
    Layout layout;
    layout.angle = angle;
    auto points =
        scatter<2>(Vec<2>(0.1, 0.2), 5.0, 1.0, layout, [](const Vec<2>&) { return true; });
    const Mat<2> back = scenes::turn<2>(-angle);
    const DistanceFunction distance = [&](const Vec3& x) {
      return (back * (x.head<2>() - Vec<2>(0.1, 0.2))).cwiseAbs().maxCoeff() - 5.0;
    };
    OutsideCells<2> cells(grid, 1);
    for (const bool known : {true, false}) {
      cells.start(*points, known ? distance : DistanceFunction{});
      for (double x = -7.5; x < 8.0; x += 1.0) {
        for (double y = -7.5; y < 8.0; y += 1.0) {
          const double depth = -distance(Vec3(x, y, 0.0));
          if (depth > 1.5) {
            CHECK_FALSE(is_outside(cells, x, y));
          } else if (depth < -1.5) {
            CHECK(is_outside(cells, x, y));
          }
        }
      }
      cells.follow(*points);
    }
  }
}

TEST_CASE("Outside cells survive a checkpoint") {
  auto points =
      scatter<2>(Vec<2>::Zero(), 3.0, 0.5, {}, [](const Vec<2>& y) { return y.norm() > 1.5; });
  OutsideCells<2> cells(grid, 1), again(grid, 1);
  cells.start(*points, {});
  Archive archive;
  cells.save(archive, "outside");
  again.load(archive, "outside");
  CHECK(std::equal(cells.flags().begin(), cells.flags().end(), again.flags().begin()));
}

}  // namespace
}  // namespace lapilli
