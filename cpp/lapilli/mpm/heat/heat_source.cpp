#include "lapilli/mpm/heat/heat_source.hpp"

#include <algorithm>

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

template class HeatSource<1>;
template class HeatSource<2>;
template class HeatSource<3>;

}  // namespace lapilli
