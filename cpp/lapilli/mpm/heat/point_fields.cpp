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
    conductivity.push_back(body.material.conductivity.largest().block<Dim>());
    half_width.push_back(shape == ShapeFunction::bspline ? 0.5 : body.half_width);
    largest_diffusivity = std::max(largest_diffusivity,
                                   largest_conductivity(body.material) / body.material.capacity());
  }
  uniform = true;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    uniform = uniform && bodies[b].material.conductivity.largest().is_scalar() &&
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

namespace {

/// Sums over points at the start, by node.
template <int Dim>
class InitialMap {
 public:
  InitialMap(const Points& points, const HeatProblem<Dim>& problem,
             const HeatCoefficients<Dim>& coefficients, std::span<const double> capacity,
             std::span<const double> temperature)
      : points_(points),
        problem_(problem),
        coefficients_(coefficients),
        capacity_(capacity),
        temperature_(temperature),
        mass_(static_cast<std::size_t>(problem.grid.node_count())),
        heat_(mass_.size()),
        gradient_(static_cast<std::size_t>(points.size()) * Dim, 0.0) {}

  /// Nodal temperatures of the points of one body, of all where it is negative.
  const std::vector<double>& nodal(Index body) {
    const Grid<Dim>& grid = problem_.grid;
    std::fill(mass_.begin(), mass_.end(), 0.0);
    std::fill(heat_.begin(), heat_.end(), 0.0);
    for_each_point(body, [&](Index row, const auto& weights) {
      const Vec<Dim> x = points_.position<Dim>(row);
      const Eigen::Map<const Vec<Dim>> g(gradient_.data() + row * Dim);
      const auto first = grid.node_at(weights.first);
      const Vec<Dim> corner = grid.node_position(weights.first);
      weights.for_each_node(grid, [&](Index node, double s, const Vec<Dim>&) {
        Vec<Dim> away = corner - x;
        const auto at = grid.node_at(node);
        for (int axis = 0; axis < Dim; ++axis) {
          away[axis] += (at[axis] - first[axis]) * grid.cell_size();
        }
        mass_[node] += capacity_[row] * s;
        heat_[node] += capacity_[row] * s * (temperature_[row] + g.dot(away));
      });
    });
    for (std::size_t node = 0; node < heat_.size(); ++node) {
      heat_[node] = mass_[node] > 0.0 ? heat_[node] / mass_[node] : 0.0;
    }
    return heat_;
  }

  /// Give the points of one body the gradient of the nodal temperatures.
  void take_gradient(Index body) {
    for_each_point(body, [&](Index row, const auto& weights) {
      Eigen::Map<Vec<Dim>> g(gradient_.data() + row * Dim);
      g.setZero();
      weights.for_each_node(problem_.grid, [&](Index node, double, const Vec<Dim>& slope) {
        g += heat_[node] * slope;
      });
    });
  }

  /// What every node has where all points have one temperature, without the rounding of the mean.
  std::vector<double> even() {
    std::vector<double> all(nodal(-1));
    for (std::size_t node = 0; node < all.size(); ++node) {
      all[node] = mass_[node] > 0.0 ? temperature_.front() : 0.0;
    }
    return all;
  }

  std::vector<double>& gradient() { return gradient_; }

 private:
  template <class Body>
  void for_each_point(Index wanted, const Body& body) {
    for (Index row = 0; row < points_.size(); ++row) {
      if (wanted < 0 || points_.body()[row] == wanted) {
        with_shape(problem_.shape, coefficients_.half_width[points_.body()[row]], [&](auto shape) {
          const double* x = points_.position().data() + row * Dim;
          body(row, Weights<Dim, decltype(shape)>(problem_.grid, shape, x));
        });
      }
    }
  }

  const Points& points_;
  const HeatProblem<Dim>& problem_;
  const HeatCoefficients<Dim>& coefficients_;
  std::span<const double> capacity_, temperature_;
  std::vector<double> mass_, heat_, gradient_;
};

}  // namespace

template <int Dim>
std::vector<double> map_initial(const Points& points, const HeatProblem<Dim>& problem,
                                const HeatCoefficients<Dim>& coefficients,
                                const std::vector<double>& capacity,
                                const std::vector<double>& temperature,
                                std::vector<double>* gradient) {
  InitialMap<Dim> map(points, problem, coefficients, capacity, temperature);
  const auto [low, high] = std::minmax_element(temperature.begin(), temperature.end());
  if (*low == *high) {
    std::vector<double> nodal = map.even();
    if (gradient != nullptr) {
      *gradient = std::move(map.gradient());
    }
    return nodal;
  }
  if (gradient == nullptr) {
    return map.nodal(-1);
  }
  // Body by body: a jump of temperature between bodies is no gradient of either.
  for (Index body = 0; body < static_cast<Index>(problem.bodies.size()); ++body) {
    for (int pass = 0; pass < 2; ++pass) {
      map.nodal(body);
      map.take_gradient(body);
    }
  }
  std::vector<double> nodal = map.nodal(-1);
  *gradient = std::move(map.gradient());
  return nodal;
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
