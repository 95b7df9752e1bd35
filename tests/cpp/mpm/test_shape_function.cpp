#include <catch2/catch.hpp>

#include "lapilli/mpm/transfer/patch_weights.hpp"
#include "lapilli/mpm/transfer/weights.hpp"
#include "mpm/point_sets.hpp"

namespace lapilli {
namespace {

double hat(double x) { return std::max(0.0, 1.0 - std::abs(x)); }

/// The hat averaged over [x - l, x + l], piece by piece: exact with one midpoint a straight piece.
double averaged_hat(double x, double l) {
  std::vector<double> ends{x - l, x + l};
  for (const double kink : {-1.0, 0.0, 1.0}) {
    if (kink > x - l && kink < x + l) {
      ends.push_back(kink);
    }
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    sum += (ends[k + 1] - ends[k]) * hat(0.5 * (ends[k] + ends[k + 1]));
  }
  return sum / (2.0 * l);
}

double quadratic_spline(double x) {
  x = std::abs(x);
  return x < 0.5 ? 0.75 - x * x : x < 1.5 ? 0.5 * (1.5 - x) * (1.5 - x) : 0.0;
}

template <int Dim, class Shape>
void sums_are_exact(const Shape& shape) {
  const Grid<Dim> grid(Vec<Dim>::Constant(-0.3), Vec<Dim>::Constant(1.7), 0.25);
  scenes::Uniform uniform(3);
  for (int trial = 0; trial < 200; ++trial) {
    Vec<Dim> x;
    for (int axis = 0; axis < Dim; ++axis) {
      x[axis] = uniform.between(-0.3, 1.7);
    }
    const Weights<Dim, Shape> weights(grid, shape, x.data());
    double one = 0.0, least = 1.0;
    Vec<Dim> slope = Vec<Dim>::Zero(), place = Vec<Dim>::Zero();
    Mat<Dim> unit = Mat<Dim>::Zero();
    weights.for_each_node(grid, [&](Index node, double s, const Vec<Dim>& g) {
      one += s;
      slope += g;
      place += s * grid.node_position(node);
      unit += grid.node_position(node) * g.transpose();
      least = std::min(least, s);
    });
    CHECK(std::abs(one - 1.0) < 1e-14);
    CHECK(slope.norm() < 1e-12);
    CHECK((place - x).norm() < 1e-14);                    // linear fields are reproduced
    CHECK((unit - Mat<Dim>::Identity()).norm() < 1e-12);  // and so is their gradient
    CHECK(least >= 0.0);
  }
}

TEST_CASE("Shape functions sum to one, their gradients to zero, and reproduce linear fields") {
  sums_are_exact<1>(LinearShape{});
  sums_are_exact<2>(LinearShape{});
  sums_are_exact<3>(LinearShape{});
  for (const double half_width : {0.05, 0.125, 0.25, 0.5}) {
    sums_are_exact<1>(GimpShape(half_width));
    sums_are_exact<2>(GimpShape(half_width));
    sums_are_exact<3>(GimpShape(half_width));
  }
}

TEST_CASE("GIMP is the hat averaged over the box of the point") {
  for (const double l : {0.01, 0.1, 0.25, 0.4, 0.5}) {
    const GimpShape shape(l);
    for (int k = 0; k <= 1000; ++k) {
      const double at = 4.0 + 0.001 * k;
      const int base = GimpShape::base(at);
      double value[3], slope[3];
      shape.evaluate(at, base, value, slope);
      for (int i = 0; i < 3; ++i) {
        const double x = at - (base + i);
        // The gradient is the difference of the hat at the two ends of the box.
        CHECK(value[i] == Approx(averaged_hat(x, l)).margin(1e-14));
        CHECK(slope[i] == Approx((hat(x + l) - hat(x - l)) / (2.0 * l)).margin(1e-12));
      }
    }
  }
}

TEST_CASE("GIMP of half-width 1/2 is the quadratic B-spline") {
  const GimpShape shape(0.5);
  for (int k = 0; k <= 1000; ++k) {
    const double at = 7.0 + 0.001 * k;
    const int base = GimpShape::base(at);
    double value[3], slope[3];
    shape.evaluate(at, base, value, slope);
    for (int i = 0; i < 3; ++i) {
      CHECK(value[i] == Approx(quadratic_spline(at - (base + i))).margin(1e-14));
    }
  }
}

template <int Dim, class Shape, class ShapeOf>
void patches_equal_weights(const ShapeOf& shape_of, Index bodies) {
  const Grid<Dim> grid(Vec<Dim>::Constant(0.1), Vec<Dim>::Constant(1.3), 0.2);
  scenes::Uniform uniform(11);
  std::vector<double> position;
  std::vector<Index> body;
  for (int point = 0; point < 63; ++point) {  // 63: the last four are three
    for (int axis = 0; axis < Dim; ++axis) {
      position.push_back(uniform.between(0.1, 1.3));
    }
    body.push_back(point % bodies);
  }
  const PatchNodes<Dim, Shape> nodes(grid);
  int seen = 0;
  for_points(grid, 0, 63, position.data(), shape_of, body.data(), [&](Index row, const auto& at) {
    const Weights<Dim, Shape> weights(grid, shape_of(body[row]), position.data() + row * Dim);
    CHECK(at.first() == weights.first);
    // Scatter each through its own loops, then compare whole grids.
    const auto count = static_cast<std::size_t>(grid.node_count()) + 4;
    std::vector<double> value(count, 0.0), expected(count, 0.0);
    std::vector<std::vector<double>> slope(Dim, value), expected_slope(Dim, value);
    using Patches = PatchWeights<Dim, Shape>;
    for (int patch = 0; patch < Patches::patches; ++patch) {
      nodes.add(value.data(), at.first(), patch, at.value() * at.across(patch));
      for (int axis = 0; axis < Dim; ++axis) {
        nodes.add(slope[axis].data(), at.first(), patch,
                  axis < Patches::inner ? at.slope(axis) * at.across(patch)
                                        : at.value() * at.slope_across(patch, axis));
      }
    }
    weights.for_each_node(grid, [&](Index node, double s, const Vec<Dim>& g) {
      expected[node] += s;
      for (int axis = 0; axis < Dim; ++axis) {
        expected_slope[axis][node] += g[axis];
      }
    });
    double worst = 0.0;
    for (std::size_t node = 0; node < count; ++node) {
      worst = std::max(worst, std::abs(value[node] - expected[node]));
      for (int axis = 0; axis < Dim; ++axis) {
        worst = std::max(worst, 0.2 * std::abs(slope[axis][node] - expected_slope[axis][node]));
      }
    }
    CHECK(worst < 1e-14);
    for (int axis = 0; axis < Dim; ++axis) {
      const double base = grid.node_position(weights.first)[axis];
      CHECK(at.from_base(axis) == Approx(position[row * Dim + axis] - base).margin(1e-14));
    }
    ++seen;
  });
  CHECK(seen == 63);
}

TEST_CASE("Weights taken four points at a time are those of each point") {
  const OneShape<LinearShape> linear{LinearShape{}};
  patches_equal_weights<1, LinearShape>(linear, 1);
  patches_equal_weights<2, LinearShape>(linear, 1);
  patches_equal_weights<3, LinearShape>(linear, 1);
  const OneShape<GimpShape> one{GimpShape(0.25)};
  patches_equal_weights<1, GimpShape>(one, 1);
  patches_equal_weights<2, GimpShape>(one, 1);
  patches_equal_weights<3, GimpShape>(one, 1);
  const std::vector<GimpShape> shapes{GimpShape(0.25), GimpShape(0.125)};
  const auto two = [&](Index body) -> const GimpShape& { return shapes[body]; };
  patches_equal_weights<2, GimpShape>(two, 2);
  patches_equal_weights<3, GimpShape>(two, 2);
}

TEST_CASE("A grid says how it counts and what it holds") {
  const Grid<3> grid(Vec<3>(0.0, -1.0, 2.0), Vec<3>(1.0, 1.0, 2.5), 0.25);
  CHECK(grid.cells(0) == 4 + 2 * Grid<3>::padding);
  CHECK(grid.cells(1) == 8 + 2 * Grid<3>::padding);
  CHECK(grid.cells(2) == 2 + 2 * Grid<3>::padding);
  for (const Index node : {Index{0}, Index{17}, grid.node_count() - 1}) {
    CHECK(grid.node_index(grid.node_at(node)) == node);
  }
  for (const Index cell : {Index{0}, Index{17}, grid.cell_count() - 1}) {
    CHECK(grid.cell_index(grid.cell_at(cell)) == cell);
  }
  CHECK((grid.node_position(0) - grid.origin()).norm() == 0.0);
  CHECK(grid.contains(Vec<3>(1.0, 1.0, 2.5)));
  CHECK_FALSE(grid.contains(Vec<3>(1.0 + 1e-6, 1.0, 2.5)));
  CHECK_FALSE(grid.contains(Vec<3>(std::nan(""), 0.0, 2.2)));
  CHECK_THROWS_WITH(Grid<1>(Vec<1>(0.0), Vec<1>(1.0), 0.3), Catch::Contains("0.3"));
  CHECK_THROWS_AS(Grid<1>(Vec<1>(1.0), Vec<1>(0.0), 0.1), std::invalid_argument);
  CHECK_THROWS_AS(Grid<3>(Vec<3>::Zero(), Vec<3>::Constant(1e6), 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace lapilli
