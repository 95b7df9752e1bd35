#include <catch2/catch.hpp>

#include "cavity.hpp"
#include "lapilli/core/parallel.hpp"

using namespace lapilli;
using cavity::Case;
using cavity::Layout;
using cavity::natural_convection;

namespace {

struct Measured {
  double volume = 0.0, hot = 0.0, cold = 0.0;       // Nusselt numbers
  double u = 0.0, u_at = 0.0, v = 0.0, v_at = 0.0;  // alpha / l, l
  double most = 0.0;                                // largest local Nusselt number on the hot wall
};

/// Means over a window, since points that pass the wall make its power flicker by a percent.
Measured measure(Case& run, double begin, double end) {
  const WallSurface& walls = run.heat->walls();
  run.simulation->run_until(begin);
  const auto before = run.heat->balances()[0];
  const int looks = 8;
  Measured mean;
  std::vector<double> u(200, 0.0), v(200, 0.0), local(51, 0.0);
  const double dx = run.layout.spacing();
  for (int look = 1; look <= looks; ++look) {
    run.simulation->run_until(begin + (end - begin) * look / looks);
    run.simulation->fields();
    mean.volume += volume_mean_nusselt(run.points(), *run.flow, *run.heat, 0, {1, 1}) / looks;
    const auto values = run.flow->velocity().values();
    for (int k = 3; k < 197; ++k) {
      const double s = k / 200.0;
      u[k] += sample_fluid(run.points(), walls, values, 2, 0, Vec3(0.5, s, 0), 2.5 * dx) / looks;
      v[k] += sample_fluid(run.points(), walls, values, 2, 1, Vec3(s, 0.5, 0), 2.5 * dx) / looks;
    }
    for (int k = 0; k <= 50; ++k) {
      local[k] += wall_flux_near(run.points(), *run.heat, Vec3(0, k / 50.0, 0), dx) / looks;
    }
  }
  const auto after = run.heat->balances()[0];
  mean.hot = (after.entries[0].in - before.entries[0].in) / (end - begin);
  mean.cold = -(after.entries[1].in - before.entries[1].in) / (end - begin);
  const auto top_u = std::max_element(u.begin(), u.end());
  const auto top_v = std::max_element(v.begin(), v.end());
  mean.u = *top_u;
  mean.v = *top_v;
  mean.u_at = static_cast<double>(top_u - u.begin()) / 200.0;
  mean.v_at = static_cast<double>(top_v - v.begin()) / 200.0;
  mean.most = *std::max_element(local.begin(), local.end());
  return mean;
}

struct Benchmark {
  double rayleigh, end;
  double nusselt, u, u_at, v, v_at, most;  // de Vahl Davis 1983
  double nusselt_bar, u_bar, v_bar, noise_bar;
};

void require_bars(const Benchmark& of, int rows, double widen) {
  Layout layout;
  layout.columns = layout.rows = rows;
  Case run = natural_convection(layout, of.rayleigh);
  const Measured seen = measure(run, 0.8 * of.end, of.end);
  CAPTURE(of.rayleigh, rows, seen.volume, seen.hot, seen.cold, seen.u, seen.u_at, seen.v, seen.v_at,
          seen.most, run.flow->velocity_noise(), run.flow->density_variation().first,
          run.flow->density_variation().second, run.flow->smallest_spacing());
  CHECK(seen.volume == Approx(of.nusselt).epsilon(widen * of.nusselt_bar));
  CHECK(seen.u == Approx(of.u).epsilon(widen * of.u_bar));
  CHECK(seen.v == Approx(of.v).epsilon(widen * of.v_bar));
  CHECK(std::abs(seen.u_at - of.u_at) <= 0.015 * widen);
  CHECK(std::abs(seen.v_at - of.v_at) <= 0.015 * widen);
  CHECK(seen.hot == Approx(seen.cold).epsilon(0.01 * widen));
  CHECK(0.5 * (seen.hot + seen.cold) == Approx(seen.volume).epsilon(0.02 * widen));
  CHECK(seen.most == Approx(of.most).epsilon(0.05 * widen));
  CHECK(run.flow->velocity_noise() <= of.noise_bar);
  CHECK(run.flow->density_variation().first >= -0.02);
  CHECK(run.flow->density_variation().second <= 0.02);
  CHECK(run.flow->smallest_spacing() >= 0.7);
}

// Ra, end of the run (alpha, l), values, bars for 80 x 80 points.
constexpr Benchmark benchmarks[] = {
    {1e3, 0.30, 1.118, 3.649, 0.813, 3.697, 0.178, 1.505, 0.005, 0.015, 0.03, 0.03},
    {1e4, 0.20, 2.243, 16.178, 0.823, 19.617, 0.119, 3.528, 0.01, 0.015, 0.02, 0.03},
    {1e5, 0.15, 4.519, 34.73, 0.855, 68.59, 0.066, 7.717, 0.02, 0.03, 0.03, 0.06}};

}  // namespace

TEST_CASE("cavity at Ra 1e3 against de Vahl Davis", "[.slow]") {
  require_bars(benchmarks[0], 80, 1.0);
}
TEST_CASE("cavity at Ra 1e4 against de Vahl Davis", "[.slow]") {
  require_bars(benchmarks[1], 80, 1.0);
}
TEST_CASE("cavity at Ra 1e5 against de Vahl Davis", "[.slow]") {
  require_bars(benchmarks[2], 80, 1.0);
}

TEST_CASE("cavity at Ra 1e4 with 40 x 40 points", "[.slow]") {
  // Twice the bars of 80 x 80; the noise is that of the coarser mean.
  Benchmark coarse = benchmarks[1];
  coarse.noise_bar = 0.06;
  require_bars(coarse, 40, 2.0);
}

TEST_CASE("the literal stress shakes, the zero-energy term stills it", "[.slow]") {
  double noise[2];
  int k = 0;
  for (const Laplacian laplacian : {Laplacian::literal, Laplacian::zero_energy}) {
    Layout layout;
    layout.columns = layout.rows = 30;
    PeridynamicFlowSettings flow;
    flow.laplacian = laplacian;
    PeridynamicHeatSettings heat;
    heat.laplacian = Laplacian::compact;
    Case run = natural_convection(layout, 1e4, 0.71, heat, flow);
    run.simulation->run_until(0.06);
    noise[k++] = run.flow->velocity_noise();
  }
  REQUIRE(noise[0] > 3.0 * noise[1]);
}
