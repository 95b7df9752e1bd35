#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/filled_sums.hpp"
#include "geometry/meshes.hpp"
#include "geometry/random_points.hpp"
#include "lapilli/geometry/cell_fill.hpp"
#include "lapilli/geometry/clip.hpp"

using namespace lapilli;
using std::numbers::pi;

namespace {

FilledPoints exact_fill(const Shape& shape, const Vec3& lower, double cell, int dimension) {
  FillOptions options;
  options.clip = true;
  return fill(shape, {lower, cell, 2}, options, dimension);
}

Shape posed(const Shape& shape, Random& random, int dimension) {
  const Vec3 axis =
      dimension == 2 ? Vec3(Vec3::UnitZ())
                     : Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1));
  Rotated turned{shape, random.uniform(-180, 180), {}, {axis[0], axis[1], axis[2]}};
  std::vector<double> by;
  for (int k = 0; k < dimension; ++k) {
    by.push_back(random.uniform(-0.5, 0.5));
  }
  return Translated{Shape(turned), by};
}

}  // namespace

TEST_CASE("combinations of flat shapes keep volume and centroid in any pose and grid") {
  struct Case {
    Shape shape;
    int dimension;
    double volume;
    Vec3 centroid;
  };
  const Shape low = Box{{0, 0}, {2, 1}}, square = Box{{1, 0}, {2, 3}};
  const Shape cube = Box{{0, 0, 0}, {1, 1, 1}}, corner = Box{{0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}};
  const Shape arrow = Polygon{{{0, 0}, {2, 1}, {0, 2}, {0.5, 1}}};
  const std::vector<Case> cases = {
      {Union{{low, square}}, 2, 4.0, {1.25, 1.25, 0}},
      {Difference{square, low}, 2, 2.0, {1.5, 2.0, 0}},
      {arrow, 2, 1.5, {2.5 / 3.0, 1, 0}},
      {Intersection{{arrow, Box{{0, 0}, {2, 1}}}}, 2, 0.75, {2.5 / 3, 2.0 / 3, 0}},
      {Union{{cube, corner}}, 3, 1.875, Vec3::Constant(0.75)},
      {Difference{cube, corner}, 3, 0.875, Vec3::Constant((0.5 - 0.125 * 0.75) / 0.875)}};
  Random random(3);
  for (const Case& one : cases) {
    for (int draw = 0; draw < 6; ++draw) {
      const Shape there = posed(one.shape, random, one.dimension);
      const double cell = random.uniform(0.15, 0.4);
      const auto points = exact_fill(there, Vec3(-5, -5.1, -5.2), cell, one.dimension);
      REQUIRE(total(points) == Approx(one.volume).epsilon(1e-12));
      const auto& moved = std::get<Translated>(there);
      const auto& turned = std::get<Rotated>(*moved.shape);
      const Vec3 middle = turned.matrix() * one.centroid + place(moved.by);
      REQUIRE((centroid(points) - middle).norm() < 1e-11);
    }
  }
}

TEST_CASE("a mesh gives its exact volume and centroid in any pose") {
  Random random(5);
  for (const Mesh& mesh : {ball_mesh(3), cube_mesh(0.0, 1.0)}) {
    mesh.check(3);
    const double exact = mesh.surface->volume();
    const Vec3 middle = mesh.triangles.size() == 12 ? Vec3::Constant(0.5) : Vec3(Vec3::Zero());
    for (int draw = 0; draw < 4; ++draw) {
      const Shape there = posed(mesh, random, 3);
      const auto points = exact_fill(there, Vec3(-5, -5.1, -5.2), random.uniform(0.15, 0.4), 3);
      REQUIRE(total(points) == Approx(exact).epsilon(1e-12));
      const auto& moved = std::get<Translated>(there);
      const Vec3 centre = std::get<Rotated>(*moved.shape).matrix() * middle + place(moved.by);
      REQUIRE((centroid(points) - centre).norm() < 1e-12);
    }
  }
}

TEST_CASE("holes of a mesh stay empty and parts that overlap are joined") {
  const Mesh outer = cube_mesh(0.0, 1.0);
  const auto total_of = [](const Mesh& mesh) {
    mesh.check(3);
    return total(exact_fill(mesh, Vec3(-0.03, -0.02, -0.01), 0.25, 3));
  };
  REQUIRE(total_of(joined(outer, turned_inside_out(cube_mesh(0.25, 0.75)))) ==
          Approx(0.875).epsilon(1e-12));
  REQUIRE(total_of(joined(outer, cube_mesh(2.0, 3.0))) == Approx(2.0).epsilon(1e-12));
  // Boxes with crossing parts are measured by the distance.
  const Mesh crossing = joined(outer, cube_mesh(0.5, 1.5));
  REQUIRE(total_of(crossing) == Approx(1.875).epsilon(2e-3));
  REQUIRE_FALSE(crossing.surface->covers_once());
  const Mesh nested = joined(outer, cube_mesh(0.25, 0.75));
  REQUIRE(total_of(nested) == Approx(1.0).epsilon(1e-12));
  REQUIRE_FALSE(nested.surface->covers_once());
}

TEST_CASE("an image gives the area of its set pixels in any pose") {
  ImageMask mask;
  mask.pixel = 0.05;
  Random random(11);
  double set = 0.0;
  for (int row = 0; row < 31; ++row) {
    mask.values.emplace_back();
    for (int column = 0; column < 23; ++column) {
      mask.values.back().push_back(random.uniform() > 0.4 ? 1.0 : 0.0);
      set += mask.values.back().back();
    }
  }
  for (int draw = 0; draw < 5; ++draw) {
    const auto points = exact_fill(posed(mask, random, 2), Vec3(-5, -5, 0), 0.3, 2);
    REQUIRE(total(points) == Approx(set * 0.0025).epsilon(1e-12));
  }
}

TEST_CASE("jittered points keep the volume of the shape and stay inside") {
  FillOptions options;
  options.clip = true;
  options.jitter = 0.4;
  const Shape disk = Disk{{0.03, 0.02}, 1.0};
  const auto points = fill(disk, {Vec3(-2, -2, 0), 0.2, 2}, options, 2);
  REQUIRE(total(points) == Approx(pi).epsilon(1e-8));
  for (std::size_t k = 0; k < points.size(); ++k) {
    REQUIRE(distance(disk, {points.position[2 * k], points.position[2 * k + 1], 0}) < 1e-9);
  }
}

TEST_CASE("points of cut cells integrate the gradients of the linear functions exactly") {
  // 1, x, y, z, xy, yz, zx over each cell, against four points in each tetrahedron of it.
  const Shape cube = Rotated{Shape(Box{{0, 0, 0}, {3, 3, 3}}), 33, {1.5, 1.5, 1.5}, {1, 2, 3}};
  const auto points = fill_cells(cube, {Vec3(-2, -2, -2), 1.0, 2}, {}, 3);
  const auto moments_at = [](const Vec3& x, double weight) {
    Eigen::Matrix<double, 7, 1> all;
    all << 1.0, x[0], x[1], x[2], x[0] * x[1], x[1] * x[2], x[2] * x[0];
    return Eigen::Matrix<double, 7, 1>(weight * all);
  };
  std::map<std::array<int, 3>, Eigen::Matrix<double, 7, 1>> found;
  const auto cell_of = [](const Vec3& x) {
    return std::array{static_cast<int>(std::floor(x[0])), static_cast<int>(std::floor(x[1])),
                      static_cast<int>(std::floor(x[2]))};
  };
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 x(points.position[3 * k], points.position[3 * k + 1], points.position[3 * k + 2]);
    auto [entry, is_new] = found.try_emplace(cell_of(x), Eigen::Matrix<double, 7, 1>::Zero());
    entry->second += moments_at(x, points.volume[k]);
  }
  const Mat3 turn = std::get<Rotated>(cube).matrix();
  std::vector<Cut<3>> cuts;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 normal = turn.col(axis), middle = Vec3::Constant(1.5);
    cuts.push_back(cut_through<3>(middle + 1.5 * normal, normal));
    cuts.push_back(cut_through<3>(middle - 1.5 * normal, Vec3(-normal)));
  }
  for (const auto& [cell, sums] : found) {
    const Vec3 low(cell[0], cell[1], cell[2]);
    const auto parts = tetrahedra(clip_polyhedron(cuboid(low, low + Vec3::Ones()), cuts));
    Eigen::Matrix<double, 7, 1> exact = Eigen::Matrix<double, 7, 1>::Zero();
    for (const auto& point : quadrature(parts)) {
      exact += moments_at(point.position, point.weight);
    }
    REQUIRE((sums - exact).norm() < 1e-12);
  }
  REQUIRE(total(points) == Approx(27.0).epsilon(1e-13));
}

TEST_CASE("exact fills hold at most 1.3 times the points asked for") {
  struct Case {
    Shape shape;
    int dimension;
    double volume;
  };
  const std::vector<Case> cases = {{Box{{0.03}, {10.06}}, 1, 10.03},
                                   {Disk{{0.3, 0.2}, 5.0}, 2, 25 * pi},
                                   {Box{{0.1, 0.1}, {10.2, 10.2}}, 2, 10.1 * 10.1},
                                   {Sphere{{0.3, 0.2, 0.1}, 5.0}, 3, 4 * 125 * pi / 3},
                                   {Box{{0.1, 0.1, 0.1}, {10.2, 10.2, 10.2}}, 3, 1030.301}};
  for (const Case& one : cases) {
    const double asked = one.volume * std::pow(2.0, one.dimension);
    const Lattice lattice{Vec3(-20, -20, -20), 1.0, 2};
    const auto filled = exact_fill(one.shape, lattice.lower, 1.0, one.dimension);
    const auto by_cells = fill_cells(one.shape, lattice, {}, one.dimension);
    REQUIRE(static_cast<double>(filled.size()) <= 1.3 * asked);
    REQUIRE(static_cast<double>(by_cells.size()) <= 1.3 * asked);
    REQUIRE(total(filled) == Approx(one.volume).epsilon(1e-5));
    REQUIRE(total(by_cells) == Approx(one.volume).epsilon(1e-4));
  }
}
