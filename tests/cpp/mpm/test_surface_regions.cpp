#include "lapilli/mpm/surface/surface_regions.hpp"

#include <catch2/catch.hpp>

#include "lapilli/mpm/heat/heat_surface.hpp"
#include "lapilli/mpm/heat/point_fields.hpp"
#include "mpm/heat_scenes.hpp"
#include "mpm/point_sets.hpp"

namespace lapilli {
namespace {

using scenes::Layout;

/// A block with 9 points (3D: 8) a cell, cells of 1 m, somewhere and turned.
template <int Dim>
struct Block {
  Vec<Dim> half, centre;
  double degrees;
  Grid<Dim> grid;
  HeatProblem<Dim> problem;
  HeatCoefficients<Dim> coefficients;
  std::unique_ptr<Points> points;
  NodalAreas<Dim> areas;

  Block(const Vec<Dim>& half_size, const Vec<Dim>& place, double angle)
      : half(half_size),
        centre(place),
        degrees(angle),
        grid(Vec<Dim>::Constant(-edge()), Vec<Dim>::Constant(edge()), 1.0),
        problem(scenes::problem_on(grid, scenes::unit_body(per_axis))),
        coefficients(problem.bodies, problem.shape) {
    Layout layout;
    layout.angle = angle;
    const auto from = [size = half](const Vec<Dim>& y) { return (y.cwiseAbs() - size).maxCoeff(); };
    points = scenes::scatter<Dim>(centre, std::ceil(half.maxCoeff()), 1.0 / per_axis, layout,
                                  [&](const Vec<Dim>& y) { return from(y) < 0.0; });
    const Mat<Dim> back = scenes::turn<Dim>(-angle);
    problem.distance = [=, at = centre](const Vec3& x) {
      return from(Vec<Dim>(back * (x.template head<Dim>() - at)));
    };
    const NodalSums<Dim> sums =
        nodal_sums<Dim>(*points, problem.grid, problem.shape, coefficients.half_width);
    areas = HeatSurface<Dim>(*points, problem).areas(*points, coefficients, sums);
  }
  static constexpr int per_axis = Dim == 2 ? 3 : 2;
  double edge() const { return std::ceil(half.norm()) + 3.0; }

  /// A box in the axes of the block.
  Shape box(const Vec<Dim>& lower, const Vec<Dim>& upper) const {
    const Box straight{{lower.data(), lower.data() + Dim}, {upper.data(), upper.data() + Dim}};
    Rotated turned;
    turned.shape = Shape(straight);
    turned.degrees = degrees;
    Translated moved;
    moved.shape = Shape(turned);
    moved.by.assign(centre.data(), centre.data() + Dim);
    const Shape shape = moved;
    check(shape, Dim);
    return shape;
  }

  std::vector<std::vector<SurfacePart<Dim>>> divided(
      const std::vector<const Shape*>& regions) const {
    return divide_surface<Dim>(
        grid, areas,
        [&] {
          return surface_places<Dim>(grid, *points, problem.shape, coefficients.half_width, areas,
                                     {});
        },
        regions);
  }

  /// Area of a region, and its area vector in the axes of the block.
  std::pair<double, Vec<Dim>> measured(const Shape& region) const {
    double area = 0.0;
    Vec<Dim> vector = Vec<Dim>::Zero();
    const auto parts = divided({&region});
    for (const SurfacePart<Dim>& part : parts.front()) {
      area += part.share * areas.area[part.row];
      vector += part.vector;
    }
    return {area, scenes::turn<Dim>(-degrees) * vector};
  }
};

}  // namespace

TEST_CASE("A patch of five cells has its area at any place and angle") {
  // Along the grid it is exact; turned, the areas of the nodes themselves scatter by some per cent.
  const double degrees = GENERATE(0.0, 15.0, 30.0, 45.0);
  scenes::Uniform uniform(3);
  double worst = 0.0, square = 0.0;
  const int trials = 12;
  for (int trial = 0; trial < trials; ++trial) {
    const Block<2> block({12.0, 4.0}, {uniform(), uniform()}, degrees);
    const double from = uniform.between(-8.0, 2.0);
    const auto [area, vector] = block.measured(block.box({from, 2.0}, {from + 5.0, 7.0}));
    worst = std::max({worst, std::abs(area / 5.0 - 1.0), std::abs(vector[1] / 5.0 - 1.0),
                      std::abs(vector[0] / 5.0)});
    square += std::pow(area / 5.0 - 1.0, 2);
  }
  CAPTURE(degrees, worst, std::sqrt(square / trials));
  CHECK(worst < (degrees == 0.0 ? 1e-9 : 0.015));
  CHECK(std::sqrt(square / trials) < 0.01);
}

TEST_CASE("The end of a block has its area and direction, whether its region ends on it or below") {
  const double degrees = GENERATE(0.0, 15.0, 30.0, 45.0);
  scenes::Uniform uniform(3);
  double area_error = 0.0, along = 0.0, across = 0.0;
  const int trials = 12;
  for (int trial = 0; trial < trials; ++trial) {
    const Block<2> block({12.0, 4.0}, {uniform(), uniform()}, degrees);
    const double depth = 0.2 * (trial % 2);
    const auto [area, vector] = block.measured(block.box({12.0 - depth, -9.0}, {18.0, 9.0}));
    area_error += (area / 8.0 - 1.0) / trials;
    along += (vector[0] / 8.0 - 1.0) / trials;
    across = std::max(across, std::abs(vector[1]) / 8.0);
    CHECK(std::abs(area / 8.0 - 1.0) < 0.08);  // 0.3 of a cell at either corner
  }
  CAPTURE(degrees, area_error, along, across);
  CHECK(std::abs(area_error) < 0.025);
  CHECK(std::abs(along) < 0.025);
  CHECK(across < 0.03);
}

TEST_CASE("Laws share all of the surface, none negative") {
  const Block<2> block({6.0, 4.0}, {0.3, 0.4}, 20.0);
  const Shape first = block.box({1.3, -9.0}, {9.0, 9.0}), second = block.box({-2.1, 0.2}, {9, 9});
  const auto parts = block.divided({&first, &second, nullptr});
  std::vector<double> share(block.areas.node.size(), 0.0);
  std::vector<Vec<2>> vector(share.size(), Vec<2>::Zero());
  bool shared = false;
  for (const auto& law : parts) {
    for (const SurfacePart<2>& part : law) {
      CHECK(part.share >= 0.0);
      shared = shared || (part.share > 0.01 && part.share < 0.99);
      share[part.row] += part.share;
      vector[part.row] += part.vector;
    }
  }
  CHECK(shared);
  for (std::size_t k = 0; k < share.size(); ++k) {
    CHECK(share[k] == Approx(1.0).epsilon(1e-12));
    CHECK((vector[k] - block.areas.vector[k]).norm() < 1e-12);
  }
}

TEST_CASE("Faces and patches of a cube have their areas") {
  // The corners of a patch, where two ramps meet, count 0.1 of a face each: 2 % of 4 by 5 cells.
  const Block<3> block({5.0, 5.0, 4.0}, {0.3, 0.4, 0.1}, 0.0);
  const auto [patch, up] = block.measured(block.box({-2.2, -1.7, 3.0}, {2.8, 2.3, 6.0}));
  CAPTURE(patch, up[2]);
  CHECK(patch == Approx(20.0).epsilon(0.03));
  CHECK(up[2] == Approx(20.0).epsilon(0.03));
  const auto [face, out] = block.measured(block.box({-9.0, -9.0, 4.0}, {9.0, 9.0, 9.0}));
  CAPTURE(face, out[2]);
  CHECK(face == Approx(100.0).epsilon(0.04));
  CHECK(out[2] == Approx(100.0).epsilon(0.04));
  CHECK(std::hypot(out[0], out[1]) < 1.0);
}

}  // namespace lapilli
