// A square of 100 mm under its own weight, turned with its gravity, on rollers at both sides and
// below. Exact: u = -(b/M)(L y - y^2/2), stress -b (L - y) along gravity. The convergence test that
// a patch test cannot be.
#include <catch2/catch.hpp>

#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

struct ColumnErrors {
  double displacement = 0.0, stress = 0.0;  // relative, in the L2 norm
};

ColumnErrors solve_column(double degrees, double h, const SupportScheme& scheme) {
  const double b = 1e-3, size = 100.0;
  const Rectangle column = Rectangle::turned(degrees, h * Vec<2>(0.13, 0.29), size, size);
  const Corners c = column.corners();
  LinearProblem problem(grid_around(c, h), polygon(c), 3);
  problem.solve({{{c[3], c[0]}, HeldMotion::roller},
                 {{c[1], c[2]}, HeldMotion::roller},
                 {{c[0], c[1]}, HeldMotion::roller}},
                scheme, 0.01, -b * column.e2);
  double error = 0.0, norm = 0.0, stress_error = 0.0, stress_norm = 0.0;
  for (Index p = 0; p < problem.points.size(); ++p) {
    const double v = problem.points.volume()[p];
    const double y = column.local(problem.points.position<2>(p))[1];
    const Vec<2> there = -b / constrained_modulus * (size * y - 0.5 * y * y) * column.e2;
    const double stress = -b * (size - y);
    error += v * (problem.moved(p) - there).squaredNorm();
    norm += v * there.squaredNorm();
    stress_error += v * std::pow(column.e2.dot(problem.stress_at(p) * column.e2) - stress, 2);
    stress_norm += v * stress * stress;
  }
  return {std::sqrt(error / norm), std::sqrt(stress_error / stress_norm)};
}

}  // namespace

TEST_CASE("turned column: displacement converges at second order, stress at first") {
  // Linear elements: rates 2 and 1; the bars allow 5 and 10 % off.
  struct Row {
    double degrees;
    SupportScheme scheme;
    double page_displacement, page_stress;  // at h = 10
  };
  const SupportScheme stiff = SupportScheme::of(Enforcement::mean_gap, 1e-6, 0.05);
  for (const Row& row :
       {Row{0.0, default_scheme, 2.4e-3, 4.6e-2}, Row{20.0, default_scheme, 2.1e-3, 3.8e-2},
        Row{45.0, default_scheme, 9.6e-4, 2.2e-2}, Row{45.0, stiff, 9.6e-4, 2.2e-2}}) {
    const ColumnErrors coarse = solve_column(row.degrees, 10.0, row.scheme);
    const ColumnErrors middle = solve_column(row.degrees, 5.0, row.scheme);
    const ColumnErrors fine = solve_column(row.degrees, 2.5, row.scheme);
    INFO(row.degrees << " degrees: ru " << coarse.displacement << " " << middle.displacement << " "
                     << fine.displacement << ", rs " << coarse.stress << " " << middle.stress << " "
                     << fine.stress);
    CHECK(std::log2(coarse.displacement / middle.displacement) >= 1.9);
    CHECK(std::log2(middle.displacement / fine.displacement) >= 1.9);
    CHECK(std::log2(coarse.stress / middle.stress) >= 0.9);
    CHECK(std::log2(middle.stress / fine.stress) >= 0.9);
    CHECK(coarse.displacement == Approx(row.page_displacement).epsilon(0.1));
    CHECK(coarse.stress == Approx(row.page_stress).epsilon(0.1));
  }
}

TEST_CASE("turned column: aligned, all wall forms agree") {
  for (Enforcement form : {Enforcement::pointwise, Enforcement::mean_gap, Enforcement::nitsche}) {
    const ColumnErrors errors = solve_column(0.0, 10.0, SupportScheme::of(form, 1e-6, 0.05));
    CHECK(errors.displacement == Approx(2.4e-3).epsilon(0.03));
    CHECK(errors.stress == Approx(4.6e-2).epsilon(0.03));
  }
}
