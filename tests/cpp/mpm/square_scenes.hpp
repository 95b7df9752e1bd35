#pragma once

#include <algorithm>
#include <functional>

#include "mpm/heat_scenes.hpp"
#include "mpm/point_sets.hpp"

/// Squares, discs and cubes of unit material for the tests of stability and consistency.
namespace lapilli::scenes {

/// A scene in the making: change what matters, then call `start`.
template <int Dim>
struct Trial {
  double h = 1.0;
  double half = 6.0;  // half the side in cells; a disc or ball: the radius
  bool round = false;
  int per_axis = 2;
  Layout layout;
  Vec<Dim> centre = Vec<Dim>::Zero();
  HeatBody body = unit_body(2);
  HeatSettings settings;
  ShapeFunction shape = ShapeFunction::gimp;
  bool moving = false;

  double extent(const Vec<Dim>& y) const { return round ? y.norm() : y.cwiseAbs().maxCoeff(); }
  Grid<Dim> grid() const {
    const double edge = std::ceil(1.5 * half + 2.0) * h;
    return Grid<Dim>(Vec<Dim>::Constant(-edge), Vec<Dim>::Constant(edge), h);
  }
  HeatProblem<Dim> problem() const {
    HeatProblem<Dim> made = problem_on(grid(), body);
    made.shape = shape;
    made.bodies[0].half_width = 0.5 / per_axis;
    made.settings = settings;
    made.moving = moving;
    const Mat<Dim> back = turn<Dim>(-layout.angle);
    const Trial copy = *this;
    made.distance = [copy, back](const Vec3& x) {
      const Vec<Dim> y = back * (x.template head<Dim>() - copy.centre);
      return copy.extent(y) - copy.half * copy.h;
    };
    return made;
  }
  std::unique_ptr<Points> points() const {
    return scatter<Dim>(centre, std::ceil(half) * h, h / per_axis, layout,
                        [this](const Vec<Dim>& y) { return extent(y) < half * h; });
  }
  Simulation start(double end, double step = 0.0) const {
    return simulate<Dim>(points(), problem(), step, end);
  }
};

inline Convection convection(double coefficient, double ambient) {
  Convection law;
  law.coefficient = coefficient;
  law.ambient = ambient;
  return law;
}

/// Noise in [low, high), the same for the same points.
inline Value noise(double low, double high, unsigned seed = 1) {
  return ArrayFunction(
      [=](std::span<const Vec3>, std::span<const double>, double, std::span<double> values) {
        Uniform uniform(seed);
        for (double& value : values) {
          value = uniform.between(low, high);
        }
      });
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(std::span<const double> values) {
    for (const double value : values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  /// How far the range reaches beyond [from, to].
  double beyond(double from, double to) const { return std::max({from - low, high - to, 0.0}); }
};

/// Values of a field in the order of the points' ids.
inline std::vector<double> by_id(Simulation& simulation, const std::string& name) {
  const auto values = field(simulation, name);
  const auto id = std::as_const(simulation.points()).id();
  const std::size_t components = values.size() / id.size();
  std::vector<double> sorted(values.size());
  for (std::size_t row = 0; row < id.size(); ++row) {
    for (std::size_t c = 0; c < components; ++c) {
      sorted[id[row] * components + c] = values[row * components + c];
    }
  }
  return sorted;
}

inline double largest_difference(std::span<const double> a, std::span<const double> b) {
  double worst = a.size() == b.size() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    worst = std::max(worst, std::abs(a[k] - b[k]));
  }
  return worst;
}

}  // namespace lapilli::scenes
