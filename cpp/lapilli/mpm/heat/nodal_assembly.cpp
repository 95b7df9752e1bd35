#include "lapilli/mpm/heat/nodal_assembly.hpp"

#include <algorithm>

namespace lapilli {
namespace {

/// Call body(row, weights) for every point with its body's shape function.
template <int Dim, class Body>
void for_each_point(const Points& points, const HeatProblem<Dim>& problem,
                    const HeatCoefficients<Dim>& coefficients, const Body& body) {
  for (Index row = 0; row < points.size(); ++row) {
    with_shape(problem.shape, coefficients.half_width[points.body()[row]], [&](auto shape) {
      body(row, Weights<Dim, decltype(shape)>(problem.grid, shape,
                                              points.position().data() + row * Dim));
    });
  }
}

}  // namespace

template <int Dim>
NodalOperators<Dim> assemble_operators(const Points& points, const HeatProblem<Dim>& problem,
                                       const HeatCoefficients<Dim>& coefficients,
                                       const std::vector<double>& capacity, bool with_capacity) {
  const Grid<Dim>& grid = problem.grid;
  NodalOperators<Dim> made;
  std::vector<double> lumped(static_cast<std::size_t>(grid.node_count()), 0.0);
  for_each_point(points, problem, coefficients, [&](Index row, const auto& weights) {
    weights.for_each_node(
        grid, [&](Index node, double s, const Vec<Dim>&) { lumped[node] += capacity[row] * s; });
  });
  // A shape value of the square of a rounding error touches no node: a point exactly at the end of
  // its reach.
  const double least = 1e-28 * *std::max_element(lumped.begin(), lumped.end());
  std::vector<unsigned char>& active = made.active;
  active.resize(lumped.size());
  for (std::size_t node = 0; node < lumped.size(); ++node) {
    active[node] = lumped[node] > least;
  }
  made.rows = std::make_unique<NodeRows<Dim>>(grid, active, support_of(problem.shape) - 1);
  made.lumped.assign(static_cast<std::size_t>(made.rows->size()), 0.0);
  for (std::size_t node = 0; node < lumped.size(); ++node) {
    if (active[node] != 0) {
      made.lumped[made.rows->place(static_cast<Index>(node))] = lumped[node];
    }
  }
  made.conduction = std::make_unique<StencilMatrix<Dim>>(*made.rows);
  if (with_capacity) {
    made.capacity = std::make_unique<StencilMatrix<Dim>>(*made.rows);
  }
  for_each_point(points, problem, coefficients, [&](Index row, const auto& weights) {
    using PointWeights = std::remove_cvref_t<decltype(weights)>;
    std::array<Index, PointWeights::nodes> place;
    std::array<std::array<int, Dim>, PointWeights::nodes> at;
    std::array<double, PointWeights::nodes> value;
    std::array<Vec<Dim>, PointWeights::nodes> slope, flux;
    const Mat<Dim> conductivity =
        points.volume()[row] * coefficients.conductivity[points.body()[row]];
    int count = 0;
    double touched = 0.0;
    Vec<Dim> lost = Vec<Dim>::Zero();
    weights.for_each_node(grid, [&](Index node, double s, const Vec<Dim>& g) {
      if (active[node] != 0) {
        touched += s;
      } else {
        lost += g;
      }
      place[count] = active[node] != 0 ? made.rows->place(node) : -1;
      for (int axis = 0, rest = count; axis < Dim; ++axis, rest /= PointWeights::support) {
        at[count][axis] = rest % PointWeights::support;
      }
      value[count] = s;
      slope[count] = g;
      flux[count] = conductivity * g;
      ++count;
    });
    if (!lost.isZero(0.0)) {
      // The temperature there is what the point has: linear functions slope up to a node that they
      // do not touch.
      for (int a = 0; a < count; ++a) {
        slope[a] += value[a] / touched * lost;
        flux[a] = conductivity * slope[a];
      }
    }
    for (int a = 0; a < count; ++a) {
      for (int b = a; b < count; ++b) {
        if (place[a] < 0 || place[b] < 0) {
          continue;
        }
        std::array<int, Dim> step;
        for (int axis = 0; axis < Dim; ++axis) {
          step[axis] = at[b][axis] - at[a][axis];
        }
        made.conduction->add(place[a], step, slope[a].dot(flux[b]));
        if (with_capacity) {
          made.capacity->add(place[a], step, capacity[row] * value[a] * value[b]);
        }
      }
    }
  });
  return made;
}

template <int Dim>
std::function<double(Index, const Vec<Dim>&)> nodal_conductivity(
    const Points& points, const HeatProblem<Dim>& problem,
    const HeatCoefficients<Dim>& coefficients, const NodalSums<Dim>& sums) {
  const Grid<Dim>& grid = problem.grid;
  std::vector<Mat<Dim>> mean(static_cast<std::size_t>(grid.node_count()), Mat<Dim>::Zero());
  for_each_point(points, problem, coefficients, [&](Index row, const auto& weights) {
    const double share = points.volume()[row] / grid.cell_volume();
    weights.for_each_node(grid, [&](Index node, double s, const Vec<Dim>&) {
      mean[node] += share * s * coefficients.conductivity[points.body()[row]];
    });
  });
  for (std::size_t node = 0; node < mean.size(); ++node) {
    if (sums.fraction[node] > 0.0) {
      mean[node] /= sums.fraction[node];
    }
  }
  return [mean = std::move(mean)](Index node, const Vec<Dim>& normal) {
    return normal.dot(mean[node] * normal);
  };
}

#define LAPILLI_INSTANTIATE(Dim)                                                          \
  template NodalOperators<Dim> assemble_operators(const Points&, const HeatProblem<Dim>&, \
                                                  const HeatCoefficients<Dim>&,           \
                                                  const std::vector<double>&, bool);      \
  template std::function<double(Index, const Vec<Dim>&)> nodal_conductivity(              \
      const Points&, const HeatProblem<Dim>&, const HeatCoefficients<Dim>&,               \
      const NodalSums<Dim>&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
