// Cortis et al. 5.3: simple shear of a 100 mm square on two cells of 100 mm. Both ends are fixed
// walls that slide over the grid; top and bottom hold the motion along their face. Exact shear
// stress.
#include <catch2/catch.hpp>

#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

double shear_error(double left, const SupportScheme& scheme, double ghost) {
  const Corners c = Rectangle::turned(0.0, {left, 0.0}, 100.0, 100.0).corners();
  LinearProblem problem(Grid<2>({0.0, 0.0}, {200.0, 100.0}, 100.0), polygon(c), 20);
  problem.solve({{{c[3], c[0]}, HeldMotion::fixed},
                 {{c[1], c[2]}, HeldMotion::fixed, {0.0, 10.0}},
                 {{c[0], c[1]}, HeldMotion::tangent},
                 {{c[2], c[3]}, HeldMotion::tangent}},
                scheme, ghost);
  const double exact = 0.1 * elastic.shear_modulus();
  double error = 0.0;
  for (Index p = 0; p < problem.points.size(); ++p) {
    error += problem.points.volume()[p] * std::abs(problem.stress_at(p)(0, 1) / exact - 1.0) / 1e4;
  }
  CHECK(problem.volume() == Approx(1e4).epsilon(1e-12));
  return error;
}

}  // namespace

TEST_CASE("simple shear: slivers and walls on nodes do not matter") {
  // Slivers of 1e-8 cells lose the digits of their coordinates: 1e-16 / 1e-8; the paper: 2e-8.
  for (double left : {0.0, 1e-6, 1e-3, 0.1, 1.0, 2.5, 5.0, 20.0, 50.0, 80.0, 95.0, 99.0, 99.9,
                      99.999, 99.999999, 100.0}) {
    INFO("wall at " << left << " mm");
    CHECK(shear_error(left, literal_scheme, 0.0) <= 2e-8);
    CHECK(shear_error(left, SupportScheme::of(Enforcement::mean_gap, 1e-6, 0.05), 0.01) <= 2e-8);
    CHECK(shear_error(left, default_scheme, 0.01) <= 2e-8);
  }
}
