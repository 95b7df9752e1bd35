#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "lapilli/core/simulation.hpp"
#include "lapilli/peridynamics/build.hpp"
#include "lapilli/peridynamics/diagnostics.hpp"

namespace cavity {

using namespace lapilli;

/// A box [0, width] x [0, 1] of columns x rows points, with `layers` of wall points in four bodies:
/// 1 left, 2 right (both with the corners), 3 bottom, 4 top. `offset` is where the first row lies
/// in front of the surface, in spacings: 0.5 for walls between points, 1 for walls on points.
struct Layout {
  int columns = 20, rows = 20, layers = 3;
  double offset = 0.5, jitter = 0.0;
  unsigned seed = 1;
  double spacing() const { return 1.0 / (rows - 1 + 2 * offset); }
  double width() const { return (columns - 1 + 2 * offset) * spacing(); }
};

inline std::unique_ptr<Points> make_points(const Layout& layout) {
  auto points = std::make_unique<Points>(2);
  const double dx = layout.spacing();
  std::vector<double> position[5], volume[5];
  std::mt19937 generator(layout.seed);
  std::uniform_real_distribution<double> jitter(-layout.jitter * dx, layout.jitter * dx);
  for (int j = -layout.layers; j < layout.rows + layout.layers; ++j) {
    for (int i = -layout.layers; i < layout.columns + layout.layers; ++i) {
      int body = 0;
      if (i < 0) {
        body = 1;
      } else if (i >= layout.columns) {
        body = 2;
      } else if (j < 0) {
        body = 3;
      } else if (j >= layout.rows) {
        body = 4;
      }
      double x = (i + layout.offset) * dx, y = (j + layout.offset) * dx;
      if (body == 0 && layout.jitter > 0.0) {
        x += jitter(generator);
        y += jitter(generator);
      }
      position[body].insert(position[body].end(), {x, y});
      volume[body].push_back(dx * dx);
    }
  }
  for (int body = 0; body < 5; ++body) {
    points->append(position[body], volume[body], body);
  }
  return points;
}

inline FluidDistance box_distance(const Layout& layout) {
  const double width = layout.width();
  return [width](const Vec3& x) {
    const double across = std::abs(x[0] - 0.5 * width) - 0.5 * width;
    const double up = std::abs(x[1] - 0.5) - 0.5;
    const double outside = std::hypot(std::max(across, 0.0), std::max(up, 0.0));
    return outside + std::min(std::max(across, up), 0.0);
  };
}

inline std::vector<FluidWall> make_walls(double left, double right) {
  std::vector<FluidWall> walls(4);
  const char* names[] = {"left", "right", "bottom", "top"};
  for (int k = 0; k < 4; ++k) {
    walls[k].settings.name = names[k];
    walls[k].body = k + 1;
  }
  walls[0].settings.heat = walls[1].settings.heat = WallHeat::temperature;
  walls[0].settings.temperature = left;
  walls[1].settings.temperature = right;
  return walls;
}

/// Density, capacity, conductivity and viscosity 1, at 0 K and rest.
inline Fluid unit_fluid() {
  Fluid fluid;
  fluid.thermal = {1.0, 1.0, 1.0, 0.0, {}, {}};
  fluid.newtonian.density = fluid.newtonian.viscosity = 1.0;
  fluid.bodies = {{}};
  return fluid;
}

/// A box between a wall at 1 K on the left and one at 0 K on the right, ready to run.
struct Case {
  Layout layout;
  PeridynamicHeat* heat = nullptr;
  Flow* flow = nullptr;
  std::unique_ptr<Simulation> simulation;

  Case(const Layout& of, const PeridynamicHeatSettings& heat_settings,
       std::optional<PeridynamicFlowSettings> flow_settings = {},
       std::vector<FluidWall> walls = make_walls(1.0, 0.0), const Fluid& fluid = unit_fluid())
      : layout(of) {
    auto points = make_points(layout);
    const PeridynamicScene scene{layout.spacing(), box_distance(layout), fluid,
                                 std::move(walls), heat_settings,        flow_settings};
    auto physics = build_peridynamics(*points, scene);
    heat = dynamic_cast<PeridynamicHeat*>(physics.front().get());
    flow = dynamic_cast<Flow*>(physics.back().get());
    simulation = std::make_unique<Simulation>(std::move(points), std::move(physics),
                                              Simulation::Clock{100.0, 0.0});
  }

  const Points& points() const { return simulation->points(); }
  bool fluid(Index i) const { return points().body()[i] == 0; }

  /// Relative L2 error of temperature against Eq. 41 (alpha = 1, from 0 K).
  double conduction_error() const {
    double difference = 0.0, norm = 0.0;
    for (Index i = 0; i < points().size(); ++i) {
      if (fluid(i)) {
        const double x = points().position()[2 * i];
        double exact = 1.0 - x;
        for (int n = 1; n < 100; ++n) {
          const double k = n * M_PI;
          exact -= 2.0 / k * std::sin(k * x) * std::exp(-k * k * simulation->time());
        }
        difference += std::pow(heat->temperature()[i] - exact, 2);
        norm += exact * exact;
      }
    }
    return std::sqrt(difference / norm);
  }
};

/// Air between the walls, l = alpha = dT = rho = 1, from the mean temperature.
inline Case natural_convection(const Layout& layout, double rayleigh, double prandtl = 0.71,
                               const PeridynamicHeatSettings& heat = {},
                               PeridynamicFlowSettings flow = {}) {
  Fluid fluid = unit_fluid();
  fluid.newtonian = {1.0, prandtl, 1.0, 0.5};
  fluid.bodies[0].temperature = 0.5;
  flow.gravity = {0.0, -rayleigh * prandtl};
  return Case(layout, heat, flow, make_walls(1.0, 0.0), fluid);
}

}  // namespace cavity
