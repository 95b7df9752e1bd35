#include "lapilli/mpm/heat/point_fields.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

template <int Dim>
HeatCoefficients<Dim>::HeatCoefficients(const std::vector<HeatBody>& bodies, ShapeFunction shape) {
  for (const HeatBody& body : bodies) {
    check(body.material);
    capacity.push_back(body.material.capacity());
    conductivity.push_back(body.material.conductivity.block<Dim>());
    half_width.push_back(shape == ShapeFunction::bspline ? 0.5 : body.half_width);
    largest_diffusivity = std::max(largest_diffusivity,
                                   largest_conductivity(body.material) / body.material.capacity());
  }
  uniform = true;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    uniform = uniform && bodies[b].material.conductivity.is_scalar() &&
              capacity[b] == capacity[0] && conductivity[b] == conductivity[0] &&
              half_width[b] == half_width[0];
  }
}

std::vector<double> point_capacities(const Points& points, const std::vector<HeatBody>& bodies) {
  std::vector<double> capacity(static_cast<std::size_t>(points.size()));
  for (Index row = 0; row < points.size(); ++row) {
    capacity[row] = points.volume()[row] * bodies[points.body()[row]].material.capacity();
  }
  return capacity;
}

std::vector<double> initial_temperatures(const Points& points,
                                         const std::vector<HeatBody>& bodies) {
  std::vector<double> temperature(static_cast<std::size_t>(points.size()));
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    std::vector<Index> rows;
    std::vector<Vec3> place;
    for (Index row = 0; row < points.size(); ++row) {
      if (points.body()[row] == static_cast<Index>(body)) {
        rows.push_back(row);
        Vec3 x = Vec3::Zero();
        std::copy_n(points.position().data() + row * points.dimension(), points.dimension(),
                    x.data());
        place.push_back(x);
      }
    }
    std::vector<double> values(rows.size());
    bodies[body].temperature.evaluate(place, {}, 0.0, values);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      require(std::isfinite(values[k]), "initial temperature of point ", points.id()[rows[k]],
              " of body ", body, " is not finite");
      temperature[rows[k]] = values[k];
    }
  }
  return temperature;
}

template <int Dim>
std::vector<double> map_initial(const Points& points, const HeatProblem<Dim>& problem,
                                const HeatCoefficients<Dim>& coefficients,
                                const std::vector<double>& capacity,
                                const std::vector<double>& temperature,
                                std::vector<double>* gradient) {
  const Grid<Dim>& grid = problem.grid;
  const auto nodes = static_cast<std::size_t>(grid.node_count());
  std::vector<double> carried(static_cast<std::size_t>(points.size()) * Dim, 0.0);
  std::vector<double> mass(nodes), heat(nodes);
  const auto [low, high] = std::minmax_element(temperature.begin(), temperature.end());
  const bool uniform = *low == *high;
  const int passes = gradient == nullptr || uniform ? 1 : 3;
  for (int pass = 0; pass < passes; ++pass) {
    std::fill(mass.begin(), mass.end(), 0.0);
    std::fill(heat.begin(), heat.end(), 0.0);
    const auto for_each_point = [&](const auto& body) {
      for (Index row = 0; row < points.size(); ++row) {
        with_shape(problem.shape, coefficients.half_width[points.body()[row]], [&](auto shape) {
          const double* x = points.position().data() + row * Dim;
          body(row, Weights<Dim, decltype(shape)>(grid, shape, x));
        });
      }
    };
    for_each_point([&](Index row, const auto& weights) {
      const Vec<Dim> x = points.position<Dim>(row);
      const Eigen::Map<const Vec<Dim>> g(carried.data() + row * Dim);
      const auto first = grid.node_at(weights.first);
      const Vec<Dim> corner = grid.node_position(weights.first);
      weights.for_each_node(grid, [&](Index node, double s, const Vec<Dim>&) {
        Vec<Dim> away = corner - x;
        const auto at = grid.node_at(node);
        for (int axis = 0; axis < Dim; ++axis) {
          away[axis] += (at[axis] - first[axis]) * grid.cell_size();
        }
        mass[node] += capacity[row] * s;
        heat[node] += capacity[row] * s * (temperature[row] + g.dot(away));
      });
    });
    for (std::size_t node = 0; node < nodes; ++node) {
      heat[node] = mass[node] > 0.0 ? heat[node] / mass[node] : 0.0;
    }
    if (uniform) {  // without the rounding of the mean
      for (std::size_t node = 0; node < nodes; ++node) {
        heat[node] = mass[node] > 0.0 ? temperature.front() : 0.0;
      }
    }
    if (passes == 1) {
      break;
    }
    for_each_point([&](Index row, const auto& weights) {
      Eigen::Map<Vec<Dim>> g(carried.data() + row * Dim);
      g.setZero();
      weights.for_each_node(
          grid, [&](Index node, double, const Vec<Dim>& slope) { g += heat[node] * slope; });
    });
  }
  if (gradient != nullptr) {
    *gradient = std::move(carried);
  }
  return heat;
}

template struct HeatCoefficients<1>;
template struct HeatCoefficients<2>;
template struct HeatCoefficients<3>;
#define LAPILLI_INSTANTIATE(Dim)                                            \
  template std::vector<double> map_initial(                                 \
      const Points&, const HeatProblem<Dim>&, const HeatCoefficients<Dim>&, \
      const std::vector<double>&, const std::vector<double>&, std::vector<double>*);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
