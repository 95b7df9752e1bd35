// The solver by fronts against Eigen's, and the same bytes for any number of threads.
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <catch2/catch.hpp>
#include <cstring>
#include <random>

#include "lapilli/algebra/direct_solver.hpp"
#include "lapilli/algebra/multifrontal.hpp"
#include "lapilli/core/parallel.hpp"

using namespace lapilli;

namespace {

/// A symmetric matrix on the nodes of an n x n x depth grid, `width` unknowns a node, coupled with
/// random numbers to all neighbours, in the order of a dissection.
struct Drawn {
  SparseMatrix lower;
  std::vector<int> part_start;

  Drawn(int n, int depth, int width, unsigned seed, double diagonal) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<std::array<int, 3>> place;
    for (int k = 0; k < n * n * depth; ++k) {
      place.push_back({k % n, k / n % n, k / (n * n)});
    }
    const auto near = [&](int a, int b) {
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(place[a][axis] - place[b][axis]) > 1) {
          return false;
        }
      }
      return true;
    };
    const int count = static_cast<int>(place.size());
    NodeGraph graph;
    graph.start.push_back(0);
    for (int a = 0; a < count; ++a) {
      for (int b = 0; b < count; ++b) {
        if (near(a, b)) {
          graph.neighbour.push_back(b);
        }
      }
      graph.start.push_back(static_cast<Index>(graph.neighbour.size()));
    }
    const Elimination elimination = nested_dissection(graph, place);
    for (int start : elimination.part_start) {
      part_start.push_back(width * start);
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < width * count; ++column) {
      for (int row = column; row < width * count; ++row) {
        if (near(elimination.order[row / width], elimination.order[column / width])) {
          entries.emplace_back(row, column, row == column ? diagonal : uniform(random));
        }
      }
    }
    lower.resize(width * count, width * count);
    lower.setFromTriplets(entries.begin(), entries.end());
  }
};

}  // namespace

TEST_CASE("fronts solve as Eigen does, with the same bytes for any number of threads") {
  for (const auto& [n, depth, width] : {std::array{13, 1, 2}, std::array{7, 5, 3}}) {
    const Drawn drawn(n, depth, width, 7, 90.0);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(drawn.lower.rows(), -1.0, 2.0);
    const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> eigen(drawn.lower);
    const Eigen::VectorXd expected = eigen.solve(load);
    Eigen::VectorXd first, pivots;
    for (const int threads : {1, 2, 3}) {
      set_thread_count(threads);
      Multifrontal fronts;
      fronts.analyse(drawn.lower, drawn.part_start);
      fronts.factorise(drawn.lower);
      const Eigen::VectorXd found = fronts.solve(load);
      CHECK((found - expected).norm() < 1e-13 * expected.norm());
      if (threads == 1) {
        first = found;
        pivots = fronts.pivots();
      }
      CHECK(std::memcmp(first.data(), found.data(), sizeof(double) * first.size()) == 0);
      CHECK(pivots == fronts.pivots());
    }
    set_thread_count(0);
  }
}

TEST_CASE("pivots count the negative directions of a matrix") {
  const Drawn drawn(9, 1, 2, 3, 4.0);  // far from dominated by its diagonal
  const Eigen::MatrixXd dense = Eigen::MatrixXd(drawn.lower).selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly).eigenvalues();
  const auto negative = (values.array() < 0.0).count();
  REQUIRE(negative > 0);
  DirectSolver solver;
  solver.analyse(drawn.lower, drawn.part_start);
  CHECK(solver.factorise(drawn.lower).not_positive == negative);
}
