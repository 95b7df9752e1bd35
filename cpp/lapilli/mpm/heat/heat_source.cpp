#include "lapilli/mpm/heat/heat_source.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {

template <int Dim>
bool HeatSource<Dim>::is_present(const std::vector<HeatBody>& bodies) {
  return std::any_of(bodies.begin(), bodies.end(), [](const HeatBody& body) {
    return !body.source.is_constant() || body.source.at(0.0) != 0.0;
  });
}

template <int Dim>
bool HeatSource<Dim>::depends_on_state() const {
  return std::any_of(bodies_.begin(), bodies_.end(),
                     [](const HeatBody& body) { return body.source.is_function(); });
}

template <int Dim>
void HeatSource<Dim>::assign(const Points& points, const HeatProblem<Dim>& problem,
                             const std::vector<double>& half_width) {
  const Grid<Dim>& grid = problem.grid;
  nodes_.assign(bodies_.size(), {});
  std::vector<double> volume;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Value& source = bodies_[b].source;
    if (source.is_constant() && source.at(0.0) == 0.0) {
      continue;
    }
    volume.assign(static_cast<std::size_t>(grid.node_count()), 0.0);
    for (Index row = 0; row < points.size(); ++row) {
      if (points.body()[row] != static_cast<Index>(b)) {
        continue;
      }
      with_shape(problem.shape, half_width[b], [&](auto shape) {
        const Weights<Dim, decltype(shape)> weights(grid, shape,
                                                    points.position().data() + row * Dim);
        weights.for_each_node(grid, [&](Index node, double s, const Vec<Dim>&) {
          volume[node] += points.volume()[row] * s;
        });
      });
    }
    for (Index node = 0; node < grid.node_count(); ++node) {
      if (volume[node] > 0.0) {
        nodes_[b].node.push_back(node);
        nodes_[b].volume.push_back(volume[node]);
        Vec3 position = Vec3::Zero();
        position.template head<Dim>() = grid.node_position(node);
        nodes_[b].position.push_back(position);
      }
    }
  }
}

template <int Dim>
const std::vector<typename HeatSource<Dim>::Rates>& HeatSource<Dim>::evaluate_over(
    std::span<const double> temperature, double begin, double end) {
  rates_.resize(nodes_.size());
  for (std::size_t b = 0; b < nodes_.size(); ++b) {
    Nodes& n = nodes_[b];
    Rates& given = rates_[b];
    const std::size_t count = n.node.size();
    const Value& source = bodies_[b].source;
    given.node = n.node;
    given.rate.resize(count);
    given.slope.assign(count, 0.0);
    n.state.resize(count);
    double span = 1.0;
    for (std::size_t k = 0; k < count; ++k) {
      n.state[k] = temperature[n.node[k]];
      span = std::max(span, std::abs(n.state[k]));
    }
    source.evaluate_mean(n.position, n.state, begin, end, given.rate);
    if (source.is_function()) {
      const double rise = 1e-6 * span;
      for (double& state : n.state) {
        state += rise;
      }
      n.value.resize(count);
      source.evaluate_mean(n.position, n.state, begin, end, n.value);
      for (std::size_t k = 0; k < count; ++k) {
        given.slope[k] = n.volume[k] * (given.rate[k] - n.value[k]) / rise;
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      given.rate[k] *= n.volume[k];
    }
  }
  return rates_;
}

template class HeatSource<1>;
template class HeatSource<2>;
template class HeatSource<3>;

}  // namespace lapilli
