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

/// Adds the share of one point after another to the operators.
template <int Dim, class Weights>
class PointOperators {
  static constexpr int nodes = Weights::nodes;

 public:
  PointOperators(const Grid<Dim>& grid, NodalOperators<Dim>& made) : grid_(grid), made_(made) {}

  /// K += V grad S . k grad S and, where there is one, M += m S S.
  void add(const Weights& weights, const Mat<Dim>& conductivity, double capacity) {
    find_nodes(weights);
    for (int a = 0; a < nodes; ++a) {
      flux_[a] = conductivity * slope_[a];
    }
    for (int a = 0; a < nodes; ++a) {
      for (int b = a; b < nodes; ++b) {
        if (place_[a] >= 0 && place_[b] >= 0) {
          add_pair(a, b, capacity);
        }
      }
    }
  }

 private:
  void find_nodes(const Weights& weights) {
    int count = 0;
    double touched = 0.0;
    Vec<Dim> lost = Vec<Dim>::Zero();
    weights.for_each_node(grid_, [&](Index node, double s, const Vec<Dim>& g) {
      const bool active = made_.active[node] != 0;
      touched += active ? s : 0.0;
      lost += active ? Vec<Dim>(Vec<Dim>::Zero()) : g;
      place_[count] = active ? made_.rows->place(node) : -1;
      value_[count] = s;
      slope_[count] = g;
      ++count;
    });
    if (!lost.isZero(0.0)) {
      // The temperature there is what the point has: linear functions slope up to a node that they
      // do not touch.
      for (int a = 0; a < nodes; ++a) {
        slope_[a] += value_[a] / touched * lost;
      }
    }
  }

  void add_pair(int a, int b, double capacity) {
    std::array<int, Dim> step;
    for (int axis = 0, from = a, to = b; axis < Dim; ++axis) {
      step[axis] = to % Weights::support - from % Weights::support;
      from /= Weights::support;
      to /= Weights::support;
    }
    made_.conduction->add(place_[a], step, slope_[a].dot(flux_[b]));
    if (made_.capacity) {
      made_.capacity->add(place_[a], step, capacity * value_[a] * value_[b]);
    }
  }

  const Grid<Dim>& grid_;
  NodalOperators<Dim>& made_;
  std::array<Index, nodes> place_;
  std::array<double, nodes> value_;
  std::array<Vec<Dim>, nodes> slope_, flux_;
};

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
    PointOperators<Dim, PointWeights>(grid, made)
        .add(weights, points.volume()[row] * coefficients.conductivity[points.body()[row]],
             capacity[row]);
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
