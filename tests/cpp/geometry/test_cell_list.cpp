#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "geometry/random_points.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/geometry/cell_list.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;

namespace {

const Bounds cloud{Vec3(-1, 2, 0), Vec3(3, 3, 2)};

std::vector<double> rows_of(const std::vector<Vec3>& points, int dimension) {
  std::vector<double> rows;
  for (const Vec3& x : points) {
    rows.insert(rows.end(), x.data(), x.data() + dimension);
  }
  return rows;
}

}  // namespace

TEST_CASE("points within a radius and the nearest one are those of a full search") {
  for (int dimension : {1, 2, 3}) {
    const auto points = random_points(400, dimension, cloud);
    for (double bin : {0.05, 0.3, 50.0}) {
      const CellList cells(rows_of(points, dimension), dimension, bin);
      for (const Vec3& x : random_points(50, dimension, {Vec3(-3, 0, -2), Vec3(5, 5, 4)}, 11)) {
        std::vector<Index> expected;
        Index nearest = 0;
        for (Index k = 0; k < 400; ++k) {
          const double r = (points[k] - x).norm();
          if (r <= 0.4) {
            expected.push_back(k);
          }
          nearest = r < (points[nearest] - x).norm() ? k : nearest;
        }
        REQUIRE(cells.within(x, 0.4) == expected);
        REQUIRE(cells.nearest(x) == nearest);
      }
    }
  }
}

TEST_CASE("neighbour lists are symmetric, ascending and complete for any number of threads") {
  const auto points = random_points(5000, 2, cloud);
  const auto rows = rows_of(points, 2);
  set_thread_count(1);
  const NeighbourList alone = neighbours_within(rows, 2, 0.05);
  set_thread_count(2);
  const NeighbourList shared = neighbours_within(rows, 2, 0.05);
  set_thread_count(0);
  REQUIRE(alone.start == shared.start);
  REQUIRE(alone.row == shared.row);
  Index pairs = 0;
  for (Index a = 0; a < 5000; ++a) {
    for (Index b = 0; b < 5000; ++b) {
      pairs += a != b && (points[a] - points[b]).squaredNorm() <= 0.05 * 0.05;
    }
  }
  REQUIRE(alone.start.back() == pairs);
  for (Index a = 0; a < 5000; ++a) {
    REQUIRE(std::is_sorted(alone.of(a).begin(), alone.of(a).end()));
    for (Index b : alone.of(a)) {
      REQUIRE(std::binary_search(alone.of(b).begin(), alone.of(b).end(), a));
    }
  }
}

TEST_CASE("a distance equal to the radius counts, and points in one place are neighbours") {
  const NeighbourList list = neighbours_within(std::vector<double>{0, 1, 1, 2.5}, 1, 1.0);
  REQUIRE(list.start == std::vector<Index>{0, 2, 4, 6, 6});
  REQUIRE(list.row == std::vector<Index>{1, 2, 0, 2, 0, 1});
}

TEST_CASE("a lattice keeps its neighbours at exactly the radius from both sides") {
  std::vector<double> rows;
  for (int k = 0; k < 1000; ++k) {
    rows.push_back(1e3 + 0.125 * k);
  }
  const NeighbourList list = neighbours_within(rows, 1, 0.375);
  REQUIRE(list.of(500).size() == 6);
  REQUIRE(list.start.back() == 6000 - 2 * (1 + 2 + 3));
}

TEST_CASE("bins stay as few as the points however small they are asked to be") {
  const CellList cells(std::vector<double>{0, 0, 0, 1e6, 1e6, 1e6}, 3, 1e-6);
  REQUIRE(cells.nearest(Vec3(4e5, 4e5, 4e5)) == 0);
  REQUIRE(cells.nearest(Vec3(9e9, 4e5, 4e5)) == 1);
  REQUIRE(cells.bin_size() > 1e5);
  REQUIRE(cells.nearest(Vec3(1e15, 0, 0)) == 1);
  REQUIRE_THROWS_WITH(cells.nearest(Vec3(NAN, 0, 0)), Contains("not finite"));
  REQUIRE(CellList({}, 2, 1.0).nearest(Vec3::Zero()) == -1);
}

TEST_CASE("unusable clouds are refused") {
  const std::vector<double> rows = {0, 0, 1, std::numeric_limits<double>::quiet_NaN()};
  REQUIRE_THROWS_WITH(CellList(rows, 2, 1.0), Contains("position of point 1 is not finite"));
  REQUIRE_THROWS_WITH(CellList(rows, 3, 1.0),
                      Contains("4 numbers are no whole rows of dimension 3"));
  REQUIRE_THROWS_WITH(CellList(rows, 2, 0.0),
                      Contains("bin_size must be positive and finite, got 0"));
  REQUIRE_THROWS_WITH(CellList(rows, 4, 1.0), Contains("1, 2 or 3 dimensions, got 4"));
}
