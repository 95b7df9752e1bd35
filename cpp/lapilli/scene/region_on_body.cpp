#include "lapilli/scene/region_on_body.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/geometry/come_near.hpp"
#include "lapilli/mpm/surface/surface_regions.hpp"
#include "lapilli/scene/body_points.hpp"

namespace lapilli {

bool lies_on(const Scene& scene, const Shape& region, std::size_t body) {
  const double cell = scene.grid.cell, slack = region_slack * cell;
  const std::optional<Shape> own = placed_shape(scene.bodies[body]);
  if (!own) {
    return true;
  }
  std::vector<Shape> others;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const std::optional<Shape> other = k != body ? placed_shape(scene.bodies[k]) : std::nullopt;
    if (other && come_near(*own, *other, 2.0 * cell, cell)) {
      others.push_back(*other);
    }
  }
  const Bounds a = bounds(*own), b = bounds(region), grid = grid_bounds(scene);
  const Vec3 reach = Vec3::Constant(cell);
  const Vec3 lower = grid.lower.cwiseMax(a.lower).cwiseMax(b.lower) - reach;
  const Vec3 upper = grid.upper.cwiseMin(a.upper).cwiseMin(b.upper) + reach;
  const int dimension = dimension_of(scene);
  const auto steps = [&](int axis) {
    return axis < dimension ? static_cast<Index>((upper[axis] - lower[axis]) / cell) + 1 : Index(0);
  };
  const auto has = [&](const Vec3& at) {
    if (std::abs(distance(*own, at)) > cell || distance(region, at) > cell + slack) {
      return false;
    }
    const Vec3 foot = project(*own, at);
    return covers(region, foot, slack) && std::ranges::all_of(others, [&](const Shape& other) {
             return distance(other, foot) > cell;
           });
  };
  for (Index i = 0; i <= steps(0); ++i) {
    for (Index j = 0; j <= steps(1); ++j) {
      for (Index k = 0; k <= steps(2); ++k) {
        Vec3 at = Vec3::Zero();
        const Index count[] = {i, j, k};
        for (int axis = 0; axis < dimension; ++axis) {
          at[axis] = lower[axis] + cell * static_cast<double>(count[axis]);
        }
        if (has(at)) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace lapilli
