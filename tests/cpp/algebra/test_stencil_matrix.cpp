#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "lapilli/algebra/stencil_matrix.hpp"
#include "mpm/point_sets.hpp"

namespace lapilli {
namespace {

template <int Dim>
void product_is_that_of_the_dense_matrix(int reach) {
  const Grid<Dim> grid(Vec<Dim>::Zero(), Vec<Dim>::Constant(Dim == 3 ? 3.0 : 9.0), 1.0);
  scenes::Uniform uniform(17);
  std::vector<unsigned char> active(static_cast<std::size_t>(grid.node_count()), 0);
  std::vector<Index> nodes;
  for (Index node = 0; node < grid.node_count(); ++node) {
    const auto at = grid.node_at(node);
    bool inner = true;
    for (int axis = 0; axis < Dim; ++axis) {
      inner = inner && at[axis] >= reach && at[axis] < grid.nodes(axis) - reach;
    }
    if (inner && uniform() < 0.6) {
      active[node] = 1;
      nodes.push_back(node);
    }
  }
  const NodeRows<Dim> rows(grid, active, reach);
  StencilMatrix<Dim> matrix(rows);
  const auto count = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = 0; b < count; ++b) {
      const auto from = grid.node_at(nodes[a]), to = grid.node_at(nodes[b]);
      std::array<int, Dim> step;
      bool near = true;
      for (int axis = 0; axis < Dim; ++axis) {
        step[axis] = to[axis] - from[axis];
        near = near && std::abs(step[axis]) <= reach;
      }
      if (near && StencilMatrix<Dim>::is_later(step)) {
        const double value = uniform.between(-1.0, 1.0);
        matrix.add(rows.place(nodes[a]), step, value);
        dense(a, b) = dense(b, a) = value;
      }
    }
  }
  std::vector<double> x(static_cast<std::size_t>(rows.size()), 0.0), product(x);
  Eigen::VectorXd packed(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    packed[a] = x[rows.place(nodes[a])] = uniform.between(-1.0, 1.0);
  }
  matrix.multiply(x.data(), [&](Index place, int lanes, const auto& block) {
    for (int k = 0; k < lanes; ++k) {
      product[place + k] = block[k];
    }
  });
  const Eigen::VectorXd expected = dense * packed;
  std::vector<double> size(x.size());
  std::transform(x.begin(), x.end(), size.begin(), [](double v) { return std::abs(v); });
  const std::vector<double> absolute = matrix.absolute_multiply(size);
  const Eigen::VectorXd expected_absolute = dense.cwiseAbs() * packed.cwiseAbs();
  std::vector<Index> number(x.size(), -1);
  for (Eigen::Index a = 0; a < count; ++a) {
    const Index place = rows.place(nodes[a]);
    number[place] = a;
    CHECK(product[place] == Approx(expected[a]).margin(1e-13));
    CHECK(absolute[place] == Approx(expected_absolute[a]).margin(1e-13));
  }
  std::vector<Eigen::Triplet<double>> triplets;
  matrix.append_triplets(number, 2.0, triplets);
  Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(count, count);
  for (const auto& t : triplets) {
    CHECK(t.row() >= t.col());
    lower(t.row(), t.col()) += t.value();
  }
  const Eigen::MatrixXd expected_lower = 2.0 * dense.triangularView<Eigen::Lower>().toDenseMatrix();
  CHECK((lower - expected_lower).norm() < 1e-13);
}

TEST_CASE("A stencil matrix multiplies as the dense one does") {
  for (const int reach : {1, 2}) {
    product_is_that_of_the_dense_matrix<1>(reach);
    product_is_that_of_the_dense_matrix<2>(reach);
    product_is_that_of_the_dense_matrix<3>(reach);
  }
}

}  // namespace
}  // namespace lapilli
