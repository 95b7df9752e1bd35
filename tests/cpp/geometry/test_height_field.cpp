#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/filled_sums.hpp"
#include "geometry/random_points.hpp"
#include "geometry/scratch_file.hpp"
#include "lapilli/geometry/esri_grid.hpp"
#include "lapilli/geometry/support.hpp"

using namespace lapilli;
using Catch::Matchers::Contains;

namespace {

HeightField field(std::vector<std::vector<double>> values, double spacing, double bottom = 0.0) {
  HeightField ground;
  ground.values = std::move(values);
  ground.spacing = spacing;
  ground.bottom = bottom;
  return ground;
}

}  // namespace

TEST_CASE("ground in two dimensions is the polygon below its heights") {
  HeightField ground = field({{1.0, 2.0, 0.5}}, 2.0, -1.0);
  ground.origin = {0.5};
  ground.check(2);
  const Polygon polygon{{{0.5, -1}, {4.5, -1}, {4.5, 0.5}, {2.5, 2}, {0.5, 1}}};
  for (const Vec3& x : random_points(300, 2, {Vec3(-1, -2, 0), Vec3(6, 4, 0)})) {
    REQUIRE(distance(ground, x) == Approx(distance(polygon, x)));
  }
  FillOptions options;
  options.clip = true;
  // Trapezia: 2 (2 + 3) / 2 + 2 (3 + 1.5) / 2.
  REQUIRE(total(fill(ground, {Vec3(-1, -2, 0), 0.3, 2}, options, 2)) == Approx(9.5).epsilon(1e-13));
}

TEST_CASE("ground in space has the distance of its flat parts and the volume of its triangles") {
  // A plane that rises by .5 along x and falls by .25 along y.
  std::vector<std::vector<double>> values;
  for (int row = 0; row < 5; ++row) {
    values.emplace_back();
    for (int column = 0; column < 7; ++column) {
      values.back().push_back(3.0 + 0.5 * column - 0.25 * (4 - row));
    }
  }
  HeightField ground = field(values, 1.0, -1.0);
  ground.check(3);
  const Vec3 normal = Vec3(-0.5, 0.25, 1.0).normalized();
  for (const Vec3& x : random_points(200, 3, {Vec3(2, 1, 3), Vec3(4, 3, 5)})) {
    const double away = normal.dot(x - Vec3(0, 0, 3.0));
    if (std::abs(away) < 1.0) {  // nearer than to the sides
      REQUIRE(distance(ground, x) == Approx(away).margin(1e-12));
    }
  }
  FillOptions options;
  options.clip = true;
  const auto points = fill(ground, {Vec3(-1, -1, -2), 0.7, 2}, options, 3);
  REQUIRE(total(points) == Approx(24 * (4.0 + 1.5 - 0.5)).epsilon(1e-12));
  const TightBounds tight = tight_bounds(ground);
  REQUIRE(tight.is_tight);
  REQUIRE(tight.box.upper == Vec3(6, 4, 6));
}

TEST_CASE("ground is read from ESRI grids and images") {
  const std::string header = "NCOLS 3\nnrows 2\nxllcorner 10\nyllcenter 20\ncellsize 2\n";
  const ScratchFile file(header + "nodata_value -1\n4 5 6\n1 2 3\n", ".asc");
  const HeightGrid grid = read_esri_grid(file.path());
  REQUIRE(grid.x == 11.0);
  REQUIRE(grid.y == 20.0);
  REQUIRE(grid.values == std::vector<double>{4, 5, 6, 1, 2, 3});
  HeightField ground;
  ground.file = file.path();
  ground.bottom = -1.0;
  ground.check(3);
  REQUIRE(distance(ground, Vec3(11.0, 22.0, 4.0)) == Approx(0.0).margin(1e-12));
  REQUIRE(bounds(ground).upper == Vec3(15, 22, 6));

  const ScratchFile image("P2 3 2 4  1 2 3  4 4 4", ".pgm");
  HeightField drawn;
  drawn.file = image.path();
  drawn.spacing = 0.5;
  drawn.scale = 8.0;
  drawn.check(3);
  REQUIRE(bounds(drawn).upper == Vec3(1.0, 0.5, 8.0));

  const auto refused = [&](const std::string& bytes, const std::string& text) {
    const ScratchFile broken(bytes, ".asc");
    HeightField one;
    one.file = broken.path();
    REQUIRE_THROWS_WITH(check(one, 3), Contains(text) && Contains(broken.path()));
  };
  refused(header + "nodata_value -1\n4 -1 6\n1 2 3\n",
          "there is no height, but nan in row 0, column 1, at (13, 22) m");
  refused(header + "4 5 6\n1 x 3\n", "'x' is no height, in row 1, column 1");
  refused(header + "4 5 6\n1 2\n", "3 x 2 heights are promised, 5 are held");
  refused("ncols 3\nnrows 2\n1 2 3 4 5 6\n", "cellsize is missing");
  refused("P7 junk", "must be followed by a number");
}

TEST_CASE("unusable ground is refused") {
  const auto refused = [](const HeightField& ground, int dimension, const std::string& text) {
    REQUIRE_THROWS_WITH(check(ground, dimension), Contains(text));
  };
  refused(field({{1, 2}}, 1.0, 1.5), 2,
          "the height is not above the bottom: 1 in row 0, column 0, at (0, 0) m");
  refused(field({{1, 2}}, 1.0), 3, "at least 2 x 2 heights are needed, got 1 x 2");
  refused(field({{1, 2}, {1, 2}}, 1.0), 2, "one row of at least two heights is needed");
  refused(field({{1, 2}, {1}}, 1.0), 3, "row 0 has 2, row 1 has 1");
  refused(field({{1, NAN}}, 1.0), 2, "there is no height, but nan in row 0, column 1");
  HeightField ground = field({{1, 2}}, 1.0);
  ground.spacing.reset();
  refused(ground, 2, "spacing is missing");
  refused({}, 2, "give a file or values");
}
