#include <catch2/catch.hpp>
#include <random>

#include "lapilli/core/require.hpp"
#include "lapilli/peridynamics/operators.hpp"

using namespace lapilli;

namespace {

/// A cube of `side` points an axis, spacing 1, moved by up to `jitter` along each axis.
template <int Dim>
struct Cube {
  std::unique_ptr<Points> points = std::make_unique<Points>(Dim);
  std::unique_ptr<Families> families;
  std::vector<double> volume;
  BondWeight weight;

  Cube(int side, double jitter, double horizon) : weight{Influence::gaussian, horizon, 1.0, true} {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> shift(-jitter, jitter);
    Index count = 1;
    for (int d = 0; d < Dim; ++d) {
      count *= side;
    }
    std::vector<double> position;
    for (Index k = 0; k < count; ++k) {
      Index rest = k;
      for (int d = 0; d < Dim; ++d) {
        position.push_back(static_cast<double>(rest % side) +
                           (jitter > 0.0 ? shift(generator) : 0.0));
        rest /= side;
      }
    }
    volume.assign(static_cast<std::size_t>(count), 1.0);
    points->append(position, volume, 0);
    families = std::make_unique<Families>(*points, horizon, 0.3, std::vector<FamilyRole>(1));
    families->update();
  }
  NonlocalOperators<Dim> operators() const { return {*points, *families, weight, volume}; }
  std::vector<double> field(const std::function<double(const Vec<Dim>&)>& f) const {
    std::vector<double> values;
    for (Index i = 0; i < points->size(); ++i) {
      values.push_back(f(points->template position<Dim>(i)));
    }
    return values;
  }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("gradient and divergence keep linear fields on irregular points", "",
                       ((int Dim), Dim), 1, 2, 3) {
  for (const double horizon : {1.515, 3.015}) {
    const Cube<Dim> cube(Dim == 3 ? 6 : 12, 0.1, horizon);
    const auto operators = cube.operators();
    Vec<Dim> slope;
    Mat<Dim> matrix;
    for (int d = 0; d < Dim; ++d) {
      slope[d] = 1.0 - 0.7 * d;
      for (int e = 0; e < Dim; ++e) {
        matrix(d, e) = 0.3 + d - 0.4 * e;
      }
    }
    const auto scalar = cube.field([&](const Vec<Dim>& x) { return 2.0 + slope.dot(x); });
    std::vector<Vec<Dim>> vector;
    for (Index i = 0; i < cube.points->size(); ++i) {
      vector.push_back(matrix * cube.points->template position<Dim>(i));
    }
    const auto gradient = operators.gradient(scalar);
    const auto divergence = operators.divergence(vector);
    const auto corrected = operators.laplacian(scalar, Laplacian::corrected, 0.0);
    for (Index i = 0; i < cube.points->size(); ++i) {
      // Rounding only, ends of the cube included.
      REQUIRE((gradient[i] - slope).norm() < 1e-12);
      REQUIRE(std::abs(divergence[i] - matrix.trace()) < 1e-12 * (1.0 + matrix.norm()) * 10.0);
      REQUIRE(std::abs(corrected[i]) < 1e-12);
    }
  }
}

TEMPLATE_TEST_CASE_SIG("every Laplacian of a square is 2 dim inside a lattice", "",
                       ((int Dim), Dim), 1, 2, 3) {
  const Cube<Dim> cube(9, 0.0, 1.515);
  const auto operators = cube.operators();
  const auto square = cube.field([](const Vec<Dim>& x) { return x.squaredNorm(); });
  Index middle = 0, stride = 1;
  for (int d = 0; d < Dim; ++d) {
    middle += 4 * stride;
    stride *= 9;
  }
  for (const Laplacian form :
       {Laplacian::literal, Laplacian::compact, Laplacian::corrected, Laplacian::zero_energy}) {
    // Without its coefficient: with it the term adds its own share of a quadratic field.
    REQUIRE(operators.laplacian(square, form, 0.0)[middle] == Approx(2.0 * Dim).epsilon(1e-12));
  }
}

TEST_CASE("the literal Laplacian does not see the alternating field, the others do") {
  const Cube<2> cube(11, 0.0, 1.515);
  const auto operators = cube.operators();
  const auto teeth = cube.field([](const Vec<2>& x) {
    return static_cast<int>(std::lround(x[0] + x[1])) % 2 == 0 ? 1.0 : -1.0;
  });
  const Index middle = 5 * 11 + 5;
  REQUIRE(std::abs(operators.laplacian(teeth, Laplacian::literal, 0.0)[middle]) < 1e-12);
  REQUIRE(operators.laplacian(teeth, Laplacian::zero_energy, 0.5)[middle] < -1.0);
  REQUIRE(operators.laplacian(teeth, Laplacian::compact, 0.0)[middle] < -4.0);
  REQUIRE(operators.laplacian(teeth, Laplacian::corrected, 0.0)[middle] < -4.0);
}

TEST_CASE("fluxes that leave one point arrive at others") {
  const Cube<2> cube(10, 0.1, 1.515);
  const auto operators = cube.operators();
  std::vector<Vec<2>> flux;
  for (Index i = 0; i < cube.points->size(); ++i) {
    flux.push_back(
        Vec<2>(std::sin(3.0 * static_cast<double>(i)), std::cos(static_cast<double>(i))));
  }
  double sum = 0.0, size = 0.0;
  for (const double rate : operators.flux_divergence(flux)) {
    sum += rate;
    size += std::abs(rate);
  }
  REQUIRE(std::abs(sum) < 1e-13 * size);
}

TEST_CASE("a family that does not span the plane is named") {
  Points points(2);
  points.append(std::vector<double>{0, 0, 1, 0, 2, 0}, std::vector<double>{1, 1, 1}, 0);
  Families families(points, 1.5, 0.1, {FamilyRole{}});
  families.update();
  REQUIRE_THROWS_AS((NonlocalOperators<2>(points, families, {Influence::gaussian, 1.5, 1.0, true},
                                          points.volume())),
                    RunError);
}
