// A symmetric system on the nodes of a grid against Eigen's factor.
#include <Eigen/SparseCholesky>
#include <catch2/catch.hpp>
#include <random>

#include "lapilli/algebra/symmetric_factor.hpp"

using namespace lapilli;

namespace {

/// A positive matrix over a part of an n x n grid, coupled to neighbours and, as nodes that follow
/// others do, here and there to nodes three away.
struct Drawn {
  SparseMatrix matrix;
  std::vector<std::array<int, 3>> place;

  Drawn(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<int> number(static_cast<std::size_t>(n * n), -1);
    for (int k = 0; k < n * n; ++k) {
      if (uniform(random) < 0.9) {
        number[k] = static_cast<int>(place.size());
        place.push_back({k % n, k / n, 0});
      }
    }
    std::vector<Eigen::Triplet<double>> entries;
    const auto couple = [&](int a, int b, double value) {
      for (const auto& [row, column, sign] :
           {std::tuple{a, a, 1.0}, {b, b, 1.0}, {a, b, -1.0}, {b, a, -1.0}}) {
        entries.emplace_back(row, column, sign * value);
      }
    };
    for (int k = 0; k < n * n; ++k) {
      if (number[k] < 0) {
        continue;
      }
      entries.emplace_back(number[k], number[k], 0.01);
      const int far = uniform(random) < 0.05 ? 3 : 1;
      if (k % n + far < n && number[k + far] >= 0) {
        couple(number[k], number[k + far], uniform(random));
      }
      if (k / n + far < n && number[k + far * n] >= 0) {
        couple(number[k], number[k + far * n], uniform(random));
      }
    }
    const auto size = static_cast<Eigen::Index>(place.size());
    matrix.resize(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
  }
};

}  // namespace

TEST_CASE("a factor on grid nodes solves what Eigen solves") {
  for (const int n : {1, 2, 7, 40}) {
    const Drawn drawn(n, 20 + static_cast<unsigned>(n));
    if (drawn.place.empty()) {
      continue;
    }
    const Eigen::VectorXd right = Eigen::VectorXd::Random(drawn.matrix.cols());
    SymmetricFactor factor;
    factor.analyse(drawn.matrix, drawn.place);
    // Twice: the second time with other values of the same pattern.
    for (const double scale : {1.0, 3.0}) {
      const SparseMatrix matrix = scale * drawn.matrix;
      CHECK(factor.factorise(matrix).not_positive == 0);
      const Eigen::SimplicialLDLT<SparseMatrix> peer(matrix);
      const Eigen::VectorXd expected = peer.solve(right);
      // Condition near 1e3: rounding leaves 1e-13 of the largest value.
      CHECK((factor.solve(right) - expected).cwiseAbs().maxCoeff() <
            1e-12 * expected.cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("a factor says that a matrix is not positive") {
  const Drawn drawn(7, 5);
  SparseMatrix matrix = drawn.matrix;
  matrix.coeffRef(3, 3) = -1.0;
  SymmetricFactor factor;
  factor.analyse(matrix, drawn.place);
  CHECK(factor.factorise(matrix).not_positive > 0);
}
