#include <catch2/catch.hpp>

#include "cavity.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

using namespace lapilli;
using cavity::Case;
using cavity::Layout;
using cavity::natural_convection;

namespace {

Layout square(int rows) {
  Layout layout;
  layout.columns = layout.rows = rows;
  return layout;
}

/// Acceleration along x of the fluid over one short step from the velocity `along(y)`.
std::vector<double> acceleration(const Layout& layout, const PeridynamicFlowSettings& flow,
                                 const std::vector<FluidWall>& walls,
                                 const std::function<double(double)>& along,
                                 std::vector<double>& height) {
  Case run(layout, {}, flow, walls);
  auto velocity = run.flow->velocity().values();
  for (Index i = 0; i < run.points().size(); ++i) {
    if (run.fluid(i)) {
      velocity[2 * i] = along(run.points().position()[2 * i + 1]);
    }
  }
  const std::vector<double> before(velocity.begin(), velocity.end());
  std::vector<Index> id(run.points().id().begin(), run.points().id().end());
  std::vector<double> first(before.size());
  for (std::size_t i = 0; i < id.size(); ++i) {
    first[id[i]] = before[2 * i];
  }
  const double step = 1e-7;
  run.simulation->run_until(step);
  std::vector<double> result;
  height.clear();
  for (Index i = 0; i < run.points().size(); ++i) {
    const double x = run.points().position()[2 * i], y = run.points().position()[2 * i + 1];
    if (run.fluid(i) && std::abs(x - 0.5 * layout.width()) < 0.1 && y < 0.5) {
      result.push_back((run.flow->velocity()[2 * i] - first[run.points().id()[i]]) / step);
      height.push_back(y);
    }
  }
  return result;
}

}  // namespace

TEST_CASE("shear along a wall that holds the fluid is kept up to the wall") {
  const Layout layout = square(20);
  PeridynamicFlowSettings flow;
  flow.sound_speed = 1.0;  // quiet: only viscosity acts
  std::vector<double> height;
  const auto shear = [](double y) { return 2.0 * y; };
  const auto corrected = acceleration(layout, flow, cavity::make_walls(0.0, 0.0), shear, height);
  REQUIRE(corrected.size() > 20);
  for (const double a : corrected) {
    // Rounding of nu v / dx^2 = 400 over the step; a wall at rest at its points would brake by
    // tens.
    REQUIRE(std::abs(a) < 1e-3);
  }
  const auto parabola = acceleration(
      layout, flow, cavity::make_walls(0.0, 0.0), [](double y) { return y * (1.0 - y); }, height);
  for (std::size_t k = 0; k < parabola.size(); ++k) {
    // nu v'' = -2; next to the wall the straight continuation of the profile takes its share.
    REQUIRE(parabola[k] == Approx(-2.0).margin(height[k] < 0.15 ? 1.7 : 1e-2));
  }
}

TEST_CASE("a wall that lets slip does not brake, one that holds does") {
  const Layout layout = square(20);
  PeridynamicFlowSettings flow;
  flow.sound_speed = 1.0;
  auto walls = cavity::make_walls(0.0, 0.0);
  std::vector<double> height;
  const auto plug = [](double) { return 1.0; };
  auto held = acceleration(layout, flow, walls, plug, height);
  REQUIRE(*std::min_element(held.begin(), held.end()) < -100.0);
  walls[2].settings.slip = Slip::free_slip;
  auto slipping = acceleration(layout, flow, walls, plug, height);
  for (const double a : slipping) {
    REQUIRE(std::abs(a) < 1e-3);
  }
}

TEST_CASE("a lid drags the fluid along; a wall that moves takes its points with it") {
  PeridynamicFlowSettings flow;
  for (const bool moves : {false, true}) {
    auto walls = cavity::make_walls(0.0, 0.0);
    walls[3].settings.velocity = {2.0, 0.0};
    walls[3].settings.moves = moves;
    Case run(square(10), {}, flow, walls);
    REQUIRE(run.flow->sound_speed() == Approx(20.0));  // 10 wall speeds
    double wall_before = 0.0, wall_after = 0.0, dragged = 0.0;
    for (Index i = 0; i < run.points().size(); ++i) {
      wall_before += run.points().body()[i] == 4 ? run.points().position()[2 * i] : 0.0;
    }
    run.simulation->run_until(0.02);
    int wall_points = 0;
    for (Index i = 0; i < run.points().size(); ++i) {
      if (run.points().body()[i] == 4) {
        wall_after += run.points().position()[2 * i];
        ++wall_points;
      } else if (run.fluid(i) && run.points().position()[2 * i + 1] > 0.9) {
        dragged += run.flow->velocity()[2 * i] / 10;
      }
    }
    REQUIRE(dragged > 0.2);
    REQUIRE((wall_after - wall_before) / wall_points == Approx(moves ? 0.04 : 0.0).margin(1e-12));
  }
}

TEST_CASE("the sound speed follows what drives the flow") {
  const Layout layout = square(10);
  REQUIRE(natural_convection(layout, 1e4).flow->sound_speed() ==
          Approx(5.0 * std::sqrt(1e4 * 0.71)).epsilon(1e-9));
  REQUIRE(natural_convection(layout, 0.0).flow->sound_speed() == Approx(7.1));
  PeridynamicFlowSettings flow;
  flow.buoyancy = Buoyancy::full;  // the uniform weight drives nothing
  Fluid fluid = cavity::unit_fluid();
  fluid.newtonian.thermal_expansion = 0.01;
  flow.gravity = {0.0, -100.0};
  REQUIRE(Case(layout, {}, flow, cavity::make_walls(1.0, 0.0), fluid).flow->sound_speed() ==
          Approx(10.0));

  // What is between a wall and the fluid at the start drives, too; so do tables at their extremes,
  // and fluxes by what conduction would need for them.
  flow = {};
  flow.gravity = {0.0, -100.0};
  fluid.bodies[0].temperature = -3.0;
  const auto speed = [&](const std::vector<FluidWall>& walls) {
    return Case(layout, {}, flow, walls, fluid).flow->sound_speed();
  };
  REQUIRE(speed(cavity::make_walls(1.0, 0.0)) == Approx(5.0 * std::sqrt(4.0)));
  auto walls = cavity::make_walls(0.0, 0.0);
  fluid.bodies[0].temperature = 0.0;
  fluid.newtonian.viscosity = 0.1;
  walls[0].settings.temperature = Table{{0.0, 1.0}, {0.0, 9.0}};
  REQUIRE(speed(walls) == Approx(5.0 * std::sqrt(9.0)));
  walls = cavity::make_walls(0.0, 0.0);
  walls[0].settings.heat = WallHeat::flux;
  walls[0].settings.flux = 16.0;
  REQUIRE(speed(walls) == Approx(5.0 * std::sqrt(16.0)));
  fluid.bodies[0].source = 25.0 * 8.0;
  REQUIRE(speed(walls) == Approx(5.0 * std::sqrt(25.0)));
  fluid.bodies[0].velocity = {6.0, 8.0};
  REQUIRE(speed(walls) == Approx(100.0));
  fluid = cavity::unit_fluid();
  // Without gravity the least extent counts.
  flow.gravity = {};
  const Layout flat{.columns = 40, .rows = 10};
  REQUIRE(Case(flat, {}, flow, cavity::make_walls(0.0, 0.0), fluid).flow->sound_speed() ==
          Approx(10.0));
  fluid.newtonian.viscosity = 0.0;
  REQUIRE_THROWS_WITH(Case(layout, {}, flow, cavity::make_walls(1.0, 0.0), fluid),
                      Catch::Contains("give sound_speed"));
}

TEST_CASE("a small cavity convects, keeps its books and its points apart") {
  Case run = natural_convection(square(16), 1e4);
  REQUIRE(run.flow->smallest_spacing() == 1.0);
  run.simulation->run_until(0.12);
  run.simulation->fields();
  REQUIRE(std::abs(run.heat->balances()[0].residual()) < 1e-12);
  const auto [low, high] = run.flow->density_variation();
  REQUIRE(low > -0.02);
  REQUIRE(high < 0.02);
  REQUIRE(run.flow->smallest_spacing() > 0.6);
  // 2.243 by de Vahl Davis; 16 x 16 points are coarse.
  REQUIRE(volume_mean_nusselt(run.points(), *run.flow, *run.heat, 0, {1.0, 1.0}) ==
          Approx(2.243).epsilon(0.15));
}

TEST_CASE("flow: any threads and a resume give the same bytes") {
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 2, 4}) {
    set_thread_count(threads);
    Case run = natural_convection(square(14), 1e5);
    run.simulation->run_until(0.004);
    Archive archive;
    run.simulation->save(archive);
    Case resumed = natural_convection(square(14), 1e5);
    resumed.simulation->load(archive);
    for (Case* one : {&run, &resumed}) {
      one->simulation->run_until(0.006);
      one->simulation->fields();  // looking must not change what follows
      one->simulation->run_until(0.01);
      auto& result = results.emplace_back();
      for (const auto& values :
           {one->points().position(), std::span<const double>(one->flow->velocity().values()),
            std::span<const double>(one->flow->density().values()),
            std::span<const double>(one->heat->temperature().values())}) {
        result.insert(result.end(), values.begin(), values.end());
      }
    }
    REQUIRE(run.flow->searches() > 3);
  }
  set_thread_count(0);
  for (const auto& result : results) {
    REQUIRE(result == results[0]);
  }
}

TEST_CASE("a run that goes wrong names the point and the cause") {
  PeridynamicFlowSettings strict;
  strict.largest_density_variation = 1e-4;
  Case dense = natural_convection(square(10), 1e4, 0.71, {}, strict);
  REQUIRE_THROWS_WITH(dense.simulation->run_until(0.05),
                      Catch::Contains("density of point") &&
                          Catch::Contains("raise sound_speed_factor or give sound_speed"));
  PeridynamicFlowSettings lax;
  lax.largest_density_variation = 1.0;
  Case escape = natural_convection(square(10), 1e4, 0.71, {}, lax);
  for (Index i = 0; i < escape.points().size(); ++i) {
    if (escape.points().id()[i] == 44) {
      escape.flow->velocity()[2 * i] = -2e6;
    }
  }
  REQUIRE_THROWS_WITH(escape.simulation->run_until(0.05),
                      Catch::Contains("point 44") && Catch::Contains("escaped"));
}

TEST_CASE("the two fields of heat outlive points that move away from walls") {
  // On a horizon of 1.5 spacings a moving point next to an insulated wall loses neighbours until
  // those left do not span the plane.
  for (const Laplacian laplacian : {Laplacian::zero_energy, Laplacian::literal}) {
    PeridynamicHeatSettings heat;
    heat.laplacian = laplacian;
    PeridynamicFlowSettings flow;
    flow.laplacian = laplacian;
    Case run = natural_convection(square(20), 1e4, 0.71, heat, flow);
    run.simulation->run_until(0.02);
    CHECK(std::abs(run.heat->balances()[0].residual()) < 1e-12);
    for (Index i = 0; i < run.points().size(); ++i) {
      REQUIRE(std::abs(run.heat->temperature()[i] - 0.5) < 0.75);
    }
  }
}

TEST_CASE("a point pushed onto another comes loose") {
  Layout layout = square(12);
  Case run = natural_convection(layout, 1e4);
  auto position = run.simulation->points().position();
  const Index one = 70, other = 71;
  position[2 * one] = position[2 * other];
  position[2 * one + 1] = position[2 * other + 1];
  run.simulation->points().moved();
  for (int step = 0; step < 300; ++step) {
    run.simulation->step();
  }
  Index a = -1, b = -1;
  for (Index i = 0; i < run.points().size(); ++i) {
    a = run.points().id()[i] == one ? i : a;
    b = run.points().id()[i] == other ? i : b;
  }
  const double apart = (run.points().position<2>(a) - run.points().position<2>(b)).norm();
  REQUIRE(apart > 0.3 * layout.spacing());
}
