#include "lapilli/mpm/heat/boundary_conditions.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {

template <int Dim>
BoundaryConditions<Dim>::BoundaryConditions(const std::vector<HeatBoundary>& laws,
                                            double absolute_zero)
    : laws_(laws), nodes_(laws.size()), account_(laws.size()), zero_(absolute_zero) {
  check_regions(laws_, Dim);
}

template <int Dim>
bool BoundaryConditions<Dim>::has_held_temperature() const {
  return std::ranges::any_of(laws_, holds_temperature);
}

/// Only a flux that does not depend on the temperature may act on negative areas.
template <int Dim>
const std::vector<double>& BoundaryConditions<Dim>::used_by(std::size_t law,
                                                            const NodalAreas<Dim>& areas) const {
  const bool is_signed = surroundings_of(laws_[law]) == nullptr && lapilli::is_linear(laws_[law]);
  return is_signed ? areas.area : areas.positive;
}

template <int Dim>
std::vector<double> BoundaryConditions<Dim>::areas_of(
    const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
    const std::function<std::vector<SurfacePlace<Dim>>()>& places) const {
  std::vector<double> found;
  const auto parts = divide_surface<Dim>(grid, areas, places, regions_of(laws_));
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    found.push_back(area_of<Dim>(parts[law], used_by(law, areas)));
  }
  return found;
}

template <int Dim>
void BoundaryConditions<Dim>::assign(
    const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
    const std::function<std::vector<SurfacePlace<Dim>>()>& places) {
  const auto parts = divide_surface<Dim>(grid, areas, places, regions_of(laws_));
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    Nodes& nodes = nodes_[law];
    nodes.node.clear();
    nodes.area.clear();
    nodes.normal.clear();
    nodes.position.clear();
    for (const SurfacePart<Dim>& part : parts[law]) {
      const double area = part.share * used_by(law, areas)[part.row];
      if (area != 0.0) {
        nodes.node.push_back(areas.node[part.row]);
        nodes.area.push_back(area);
        nodes.normal.push_back(areas.normal[part.row]);
        nodes.position.push_back(areas.position[part.row]);
      }
    }
    ratios_.scale(law, nodes.area);
    nodes.state.resize(nodes.node.size());
    nodes.rate.resize(nodes.node.size());
    nodes.slope.resize(nodes.node.size());
  }
}

template <int Dim>
void BoundaryConditions<Dim>::leave_to_obstacle(std::span<const TouchingNode<Dim>> touching,
                                                double cell) {
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    const Shape* region = region_of(laws_[law]);
    Nodes& nodes = nodes_[law];
    for (std::size_t k = 0; k < nodes.node.size(); ++k) {
      const auto found =
          std::ranges::lower_bound(touching, nodes.node[k], {}, &TouchingNode<Dim>::node);
      if (found != touching.end() && found->node == nodes.node[k] &&
          (region == nullptr || distance(*region, found->place) < region_slack * cell)) {
        nodes.area[k] *= found->free_share;
      }
    }
  }
}

template <int Dim>
void BoundaryConditions<Dim>::save(Archive& archive, const std::string& name) const {
  account_.save(archive, name);
  ratios_.save(archive, name + "/area_ratios");
}

template <int Dim>
void BoundaryConditions<Dim>::load(const Archive& archive, const std::string& name) {
  account_.load(archive, name);
  ratios_.load(archive, name + "/area_ratios");
}

template <int Dim>
void BoundaryConditions<Dim>::place_probes(
    const Grid<Dim>& grid, const std::function<bool(Index)>& is_active,
    const std::function<double(Index, const Vec<Dim>&)>& conductivity) {
  constexpr int corners = 1 << Dim;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    if (!holds_temperature(laws_[law])) {
      continue;
    }
    Nodes& nodes = nodes_[law];
    nodes.conductance.resize(nodes.node.size());
    nodes.probe.resize(nodes.node.size() * corners);
    for (std::size_t k = 0; k < nodes.node.size(); ++k) {
      const double depth = grid.cell_size();
      const Vec<Dim> probe = nodes.position[k].template head<Dim>() - depth * nodes.normal[k];
      const LinearShape shape;
      const Weights<Dim, LinearShape> weights(grid, shape, probe.data());
      std::size_t corner = k * corners;
      double sum = 0.0;
      weights.for_each_node(grid, [&](Index node, double value, const Vec<Dim>&) {
        const double weight = is_active(node) ? value : 0.0;
        nodes.probe[corner++] = {weight > 0.0 ? node : nodes.node[k], weight};
        sum += weight;
      });
      for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
        nodes.probe[c].second = sum > 0.0 ? nodes.probe[c].second / sum : 1.0 / corners;
      }
      nodes.conductance[k] = conductivity(nodes.node[k], nodes.normal[k]) / depth;
    }
  }
}

template <int Dim>
void BoundaryConditions<Dim>::require_all_used() const {
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    require_surface(laws_, law, !nodes_[law].node.empty());
  }
}

template <int Dim>
std::vector<NodeCoupling> BoundaryConditions<Dim>::couplings() const {
  constexpr std::size_t corners = 1 << Dim;
  std::vector<NodeCoupling> all;
  for (const Nodes& nodes : nodes_) {
    for (std::size_t k = 0; k < nodes.conductance.size(); ++k) {
      for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
        if (nodes.probe[c].first != nodes.node[k]) {
          all.push_back({nodes.node[k], nodes.probe[c].first,
                         nodes.area[k] * nodes.conductance[k] * nodes.probe[c].second});
        }
      }
    }
  }
  return all;
}

template <int Dim>
SurfaceView BoundaryConditions<Dim>::surface() const {
  SurfaceView view;
  view.dimension = Dim;
  for (const Nodes& nodes : nodes_) {
    view.append(nodes);
  }
  return view;
}

template class BoundaryConditions<1>;
template class BoundaryConditions<2>;
template class BoundaryConditions<3>;

}  // namespace lapilli
