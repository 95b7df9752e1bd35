#include <catch2/catch.hpp>
#include <set>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/transfer/cell_order.hpp"
#include "lapilli/mpm/transfer/weights.hpp"
#include "mpm/point_sets.hpp"

namespace lapilli {
namespace {

template <int Dim>
std::unique_ptr<Points> anywhere(double low, double high) {
  scenes::Layout layout;
  layout.random = true;
  return scenes::scatter<Dim>(Vec<Dim>::Constant(0.5 * (low + high)), 0.5 * (high - low),
                              Dim == 3 ? 0.2 : 0.05, layout, [](const auto&) { return true; });
}

template <int Dim, class Shape>
void strips_of_a_parity_stay_apart(const Shape& shape) {
  const Grid<Dim> grid(Vec<Dim>::Constant(-2.0), Vec<Dim>::Constant(4.0), 0.25);
  auto points = anywhere<Dim>(-1.7, 3.7);
  CellOrder<Dim> order(grid, Shape::support);
  order.update(*points);
  const Index ordering = points->ordering();
  // Almost a whole layer of drift either way: still in order, and still apart.
  scenes::Uniform uniform(5);
  for (double& x : points->position()) {
    x += 0.25 * uniform.between(-0.99, 0.99);
  }
  points->moved();
  order.update(*points);
  CHECK(points->ordering() == ordering);
  std::vector<std::set<Index>> seen(2);
  Index parity = 0, last = -1, rows = 0;
  order.for_each_strip([&](Index begin, Index end) {
    parity = begin < last ? 1 : parity;
    last = begin;
    rows += end - begin;
    std::set<Index> touched;
    for (Index row = begin; row < end; ++row) {
      const Weights<Dim, Shape> weights(grid, shape, points->position().data() + row * Dim);
      weights.for_each_node(grid,
                            [&](Index node, double, const Vec<Dim>&) { touched.insert(node); });
    }
    for (const Index node : touched) {
      CHECK(seen[parity].insert(node).second);
    }
  });
  CHECK(rows == points->size());
}

TEST_CASE("Strips of one parity share no node, drift included") {
  set_thread_count(1);
  strips_of_a_parity_stay_apart<1>(LinearShape{});
  strips_of_a_parity_stay_apart<1>(GimpShape{});
  strips_of_a_parity_stay_apart<2>(LinearShape{});
  strips_of_a_parity_stay_apart<2>(GimpShape{});
  strips_of_a_parity_stay_apart<3>(GimpShape{});
  set_thread_count(0);
}

TEST_CASE("Points are sorted by the lowest node they touch and take their arrays along") {
  const Grid<2> grid(Vec<2>::Zero(), Vec<2>::Ones(), 0.125);
  auto points = anywhere<2>(0.0, 1.0);
  PointArray tag(*points, 1);
  for (Index row = 0; row < points->size(); ++row) {
    tag[row] = points->position<2>(row).sum();
  }
  CellOrder<2> order(grid, 3);
  order.update(*points);
  Index before = 0;
  for (Index row = 0; row < points->size(); ++row) {
    const Weights<2, GimpShape> weights(grid, GimpShape{}, points->position().data() + 2 * row);
    CHECK(weights.first >= before);
    before = weights.first;
    CHECK(tag[row] == points->position<2>(row).sum());
  }
}

TEST_CASE("Points are sorted anew once one has drifted more than a layer") {
  const Grid<2> grid(Vec<2>::Zero(), Vec<2>::Constant(4.0), 0.25);
  auto points = anywhere<2>(1.0, 2.0);
  CellOrder<2> order(grid, 2);
  order.update(*points);
  for (double& x : points->position()) {
    x += 1.5;
  }
  points->moved();
  order.update(*points);
  std::pair<int, int> layers = order.node_layers();
  CHECK(layers.first * 0.25 + grid.origin()[1] < 2.5);
  CHECK(layers.second * 0.25 + grid.origin()[1] > 3.5);
}

TEST_CASE("A point that leaves the grid is named") {
  const Grid<2> grid(Vec<2>::Zero(), Vec<2>::Ones(), 0.25);
  auto points = anywhere<2>(0.1, 0.9);
  CellOrder<2> order(grid, 3);
  order.update(*points);
  Index row = 0;
  while (points->id()[row] != 7) {
    ++row;
  }
  points->position()[2 * row] = 1.2;
  points->moved();
  CHECK_THROWS_WITH(order.update(*points), Catch::Contains("point 7 ") && Catch::Contains("left"));
  points->position()[2 * row] = std::nan("");
  points->moved();
  CHECK_THROWS_WITH(order.update(*points),
                    Catch::Contains("point 7 ") && Catch::Contains("not finite"));
}

}  // namespace
}  // namespace lapilli
