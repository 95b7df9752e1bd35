#include <catch2/catch.hpp>
#include <ctime>
#include <cstdio>
#include <cstdlib>

#include "cavity.hpp"
#include "lapilli/core/simulation.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/peridynamics/diagnostics.hpp"

using namespace lapilli;

namespace {

struct Case {
  cavity::Layout layout;
  std::shared_ptr<WallSurface> walls;
  std::unique_ptr<Simulation> simulation;
  PeridynamicHeat* heat = nullptr;
  Flow* flow = nullptr;

  Case(const cavity::Layout& of, double rayleigh, PeridynamicHeatSettings heat_settings = {},
       PeridynamicFlowSettings flow_settings = {})
      : layout(of) {
    auto points = cavity::make_points(layout);
    walls = std::make_shared<WallSurface>(*points, cavity::make_walls(1.0, 0.0),
                                          cavity::box_distance(layout), layout.spacing());
    heat_settings.initial_temperature = 0.5;
    flow_settings.viscosity = 0.71;
    flow_settings.expansion = 1.0;
    flow_settings.reference_temperature = 0.5;
    flow_settings.gravity = {0.0, -rayleigh * 0.71, 0.0};
    std::vector<std::unique_ptr<Physics>> physics;
    physics.push_back(std::make_unique<PeridynamicHeat>(*points, walls, heat_settings));
    heat = static_cast<PeridynamicHeat*>(physics.back().get());
    physics.push_back(make_flow(*points, walls, flow_settings, heat));
    flow = static_cast<Flow*>(physics.back().get());
    simulation = std::make_unique<Simulation>(std::move(points), std::move(physics),
                                              Simulation::Clock{10.0, 0.0});
  }
  void report(double seconds) {
    simulation->fields();
    const Points& points = simulation->points();
    const double reach = 2.5 * layout.spacing();
    double u = 0, uy = 0, v = 0, vx = 0;
    for (int k = 1; k < 200; ++k) {
      const double s = k / 200.0;
      const double a = sample_fluid(points, *walls, flow->velocity().values(), 2, 0,
                                    Vec3(0.5, s, 0), reach);
      const double b = sample_fluid(points, *walls, flow->velocity().values(), 2, 1,
                                    Vec3(s, 0.5, 0), reach);
      if (a > u) u = a, uy = s;
      if (b > v) v = b, vx = s;
    }
    double mean = 0, most = 0, at = 0, least = 1e9;
    for (int k = 0; k <= 100; ++k) {
      const double nu = heat->wall_flux(0, Vec3(0, k / 100.0, 0), 1.0 * layout.spacing());
      if (nu > most) most = nu, at = k / 100.0;
      least = std::min(least, nu);
      mean += nu / 101;
    }
    std::printf("mean profile %.4f ", mean);
    const NusseltScale scale{1.0, 1.0};
    std::vector<double> rate(points.size()), from;
    heat->exchange().rates(heat->temperature().data(), {{1.0, 0}, {0, 0}, {0, 0}, {0, 0}}, rate.data(), from);
    double s_x = 0, tx = 0, ux = 0, sy = 0, near[8] = {0}, cnt[8] = {0};
    for (Index i = 0; i < points.size(); ++i) {
      if (walls->wall(i) >= 0) continue;
      s_x += points.position()[2 * i] * rate[i];
      tx += points.volume()[i] * points.position()[2 * i] * heat->temperature()[i];
      ux += points.volume()[i] * flow->velocity()[2 * i] * (heat->temperature()[i] - 0.5);
      sy += points.volume()[i];
      const int b = int(points.position()[2 * i] / layout.spacing() * 2);
      if (b < 8) cnt[b] += 1, near[b] += heat->temperature()[i];
    }
    std::printf("[sum x rate %.4f uT %.4f tx %.6f vol %.5f |", s_x, ux, tx, sy);
    for (int b = 0; b < 8; ++b) std::printf(" %.0f", cnt[b]);
    std::printf("] slope");
    double q[12] = {0}, c[12] = {0};
    for (Index i = 0; i < points.size(); ++i) {
      if (walls->wall(i) >= 0 || std::abs(points.position()[2 * i + 1] - 0.5) > 0.15) continue;
      const int b = int(points.position()[2 * i] / layout.spacing() * 2);
      if (b < 12) q[b] += (1 - heat->temperature()[i]) / points.position()[2 * i], c[b] += 1;
    }
    for (int b = 0; b < 12; ++b) std::printf(" %.2f(%.0f)", q[b] / c[b], c[b]);
    std::printf("\n");
    std::printf("t %.4f n %ld Nu %.4f hot %.4f cold %.4f u %.3f@%.3f v %.3f@%.3f Numax %.3f@%.2f min %.3f | noise "
                "%.4f rho %.4f %.4f dmin %.3f imb %.2e search %ld | %.1f s %.3f us\n",
                simulation->time(), long(simulation->step_index()),
                volume_mean_nusselt(points, *walls, *flow, *heat, 0, scale),
                wall_nusselt(*heat, 0, scale), -wall_nusselt(*heat, 1, scale), u, uy, v, vx, most, at,
                least, flow->velocity_noise(), flow->density_variation().first,
                flow->density_variation().second, flow->smallest_spacing(),
                heat->exchange().imbalance(), long(flow->searches()), seconds,
                seconds / double(simulation->step_index()) / double(points.size()) * 1e6);
    std::fflush(stdout);
  }
};

double number(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : otherwise;
}

}  // namespace

TEST_CASE("explore cavity", "[.explore-cavity]") {
  set_thread_count(int(number("THREADS", 1)));
  cavity::Layout layout;
  layout.columns = layout.rows = int(number("N", 40));
  layout.offset = number("OFFSET", 0.5);
  PeridynamicHeatSettings heat;
  heat.laplacian = Laplacian(int(number("HEAT", 3)));
  heat.horizon = number("TH", 1.515);
  PeridynamicFlowSettings flow;
  flow.laplacian = Laplacian(int(number("FLOW", 3)));
  flow.sound_speed_factor = number("C0", 5);
  flow.courant = number("CFL", 0.25);
  flow.shifting = number("SHIFT", 0.1);
  flow.density_diffusion = number("DELTA", 0.1);
  Case test(layout, number("RA", 1e4), heat, flow);
  const auto begin = std::clock();
  const double end = number("END", 0.25);
  for (int k = 1; k <= 5; ++k) {
    test.simulation->run_until(end * k / 5);
    test.report(double(std::clock() - begin) / CLOCKS_PER_SEC);
  }
}
