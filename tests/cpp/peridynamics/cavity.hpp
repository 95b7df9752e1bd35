#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace cavity {

using namespace lapilli;

/// A box [0, width] x [0, 1] of columns x rows points, with `layers` of wall points in four bodies:
/// 1 left, 2 right (both with the corners), 3 bottom, 4 top. `offset` is where the first row lies in
/// front of the surface, in spacings: 0.5 for walls between points, 1 for walls on points.
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

inline std::vector<Wall> make_walls(double left, double right) {
  std::vector<Wall> walls(4);
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

}  // namespace cavity
