#include <catch2/catch.hpp>

#include "lapilli/core/require.hpp"
#include "mpm/radial_reference.hpp"
#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

using scenes::Layout;

constexpr double inner = 1.0, outer = 2.0;

PrescribedTemperature held(double value) {
  PrescribedTemperature law;
  law.value = value;
  return law;
}

/// A ring at 1 inside and 0 outside, off the grid by a part of a cell.
Simulation ring(double h, const Layout& layout, HeatTransfer transfer, double step, double end,
                bool implicit) {
  const Vec<2> centre(0.31 * h, -0.17 * h);
  const double edge = std::ceil(2.4 / h) * h;
  HeatProblem<2> problem = scenes::problem_on(
      Grid<2>(Vec<2>::Constant(-edge), Vec<2>::Constant(edge), h), scenes::unit_body(2));
  PrescribedTemperature inside = held(1.0);
  inside.region = Disk{{centre[0], centre[1]}, 0.5 * (inner + outer)};
  problem.settings.boundaries = {inside, held(0.0)};
  problem.settings.transfer = transfer;
  if (implicit) {
    problem.settings.time_integration = TimeIntegration::implicit_theta;
    problem.settings.theta = 1.0;
  }
  problem.distance = [centre](const Vec3& x) {
    const double r = (x.head<2>() - centre).norm();
    return std::max(inner - r, r - outer);
  };
  auto points =
      scenes::scatter<2>(centre, std::ceil(2.0 * outer / h) * 0.5 * h, 0.5 * h, layout,
                         [](const Vec<2>& y) { return y.norm() > inner && y.norm() < outer; });
  for (double& volume : points->volume()) {
    volume = 0.25 * h * h;
  }
  return scenes::simulate(std::move(points), problem, step, end);
}

template <class Exact>
double error(Simulation& simulation, double h, const Exact& exact) {
  const auto values = scenes::field(simulation, "temperature");
  double sum = 0.0;
  for (Index row = 0; row < simulation.points().size(); ++row) {
    const double r = (simulation.points().position<2>(row) - Vec<2>(0.31 * h, -0.17 * h)).norm();
    sum += std::pow(values[row] - exact(r), 2);
  }
  return std::sqrt(sum / static_cast<double>(simulation.points().size()));
}

TEST_CASE("Temperatures held at both radii of a ring reach the logarithm at order 1.5 or better") {
  for (const Layout& layout : {Layout{}, Layout{20.0}, Layout{0.0, 0.25}}) {
    double coarse = 0.0;
    std::string told;
    for (const double h : {0.2, 0.1, 0.05}) {
      Simulation simulation = ring(h, layout, HeatTransfer::nodal, 1e3, 4e3, true);
      simulation.run_until(4e3);
      const double now = error(
          simulation, h, [](double r) { return std::log(r / outer) / std::log(inner / outer); });
      told += message(" ", now);
      CHECK(std::abs(simulation.balances().front().residual()) <= 1e-12);
      if (h == 0.2) {
        coarse = now;
      } else if (h == 0.05) {
        INFO("angle " << layout.angle << ", jitter " << layout.jitter << ", errors" << told
                      << ", order " << 0.5 * std::log2(coarse / now));
        CHECK(0.5 * std::log2(coarse / now) >= 1.5);
      }
    }
  }
}

TEST_CASE("Held temperatures are stable and accurate at the automatic step") {
  const double end = 0.06;
  const scenes::RadialReference exact(inner, outer, {1e12, 1.0}, {1e12, 0.0}, end);
  for (const HeatTransfer transfer : {HeatTransfer::nodal, HeatTransfer::flip, HeatTransfer::pic,
                                      HeatTransfer::affine, HeatTransfer::tpic}) {
    for (const Layout& layout : {Layout{}, Layout{20.0}, Layout{0.0, 0.25}}) {
      double errors[2];
      scenes::Range range;
      for (const int level : {0, 1}) {
        const double h = level == 0 ? 0.2 : 0.1;
        Simulation simulation = ring(h, layout, transfer, 0.0, end, false);
        simulation.run_until(end);
        errors[level] = error(simulation, h, exact);
        CHECK(std::abs(simulation.balances().front().residual()) <= 1e-12);
        simulation.run_until(5.0);  // long after: nothing grows
        range.include(scenes::field(simulation, "temperature"));
      }
      INFO(name_of(transfer) << ", angle " << layout.angle << ", jitter " << layout.jitter
                             << ", errors " << errors[0] << " " << errors[1] << ", range "
                             << range.low << " " << range.high);
      // Measured 0.012 to 0.024 at two and a half cells across the boundary layer, and up to 0.037
      // beyond the range at points outside of the probes, where nodal values are extrapolated.
      CHECK(errors[1] <= 0.03);
      CHECK(errors[1] <= 0.354 * errors[0]);  // order 1.5 in passing
      CHECK(range.beyond(0.0, 1.0) <= 0.05);
    }
  }
}

// Uniform at what is held: nothing may happen, not even where the probes of a thin plate or a
// corner find no node below the surface.
TEST_CASE("A body at the temperature that is held stays there") {
  for (const HeatTransfer transfer :
       {HeatTransfer::nodal, HeatTransfer::flip, HeatTransfer::affine}) {
    for (const double thickness : {0.5, 1.0, 1.5, 3.0}) {
      const Grid<2> grid(Vec<2>::Constant(-8.0), Vec<2>::Constant(8.0), 1.0);
      HeatProblem<2> problem = scenes::problem_on(grid, scenes::unit_body(4, 300.0));
      problem.settings.boundaries = {held(300.0)};
      problem.settings.transfer = transfer;
      auto points =
          scenes::scatter<2>(Vec<2>(0.1, 0.2), 6.0, 0.25, Layout{20.0},
                             [&](const Vec<2>& y) { return std::abs(y[1]) < 0.5 * thickness; });
      Simulation simulation = scenes::simulate(std::move(points), problem, 0.0, 1e9);
      for (int k = 0; k < 20; ++k) {
        simulation.step();
      }
      scenes::Range range;
      range.include(scenes::field(simulation, "temperature"));
      INFO(name_of(transfer) << ", thickness " << thickness << ": " << range.low << " to "
                             << range.high);
      CHECK(range.beyond(300.0, 300.0) <= 1e-9);
    }
  }
}

TEST_CASE("Points that take fluxes themselves hold no temperature") {
  scenes::Trial<2> trial;
  trial.settings.method = FluxMethod::particle;
  trial.settings.transfer = HeatTransfer::flip;
  trial.settings.boundaries = {held(1.0)};
  CHECK_THROWS_WITH(trial.start(1.0), Catch::Contains("holds no temperature"));
}

}  // namespace
}  // namespace lapilli
