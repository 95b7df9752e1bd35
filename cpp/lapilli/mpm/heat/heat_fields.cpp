#include "lapilli/mpm/heat/heat_fields.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {
namespace {

/// Bring values with these capacities to one that all of them reach, as far as `heat` goes: the
/// farthest behind first, so that none passes what all of them are brought to.
void level(std::span<double> value, std::span<const double> capacity, double heat) {
  std::vector<std::size_t> order(value.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    order[k] = k;
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return heat > 0.0 ? value[a] < value[b] : value[a] > value[b];
  });
  double behind = 0.0;  // capacity
  for (std::size_t k = 0; k < order.size() && heat != 0.0; ++k) {
    behind += capacity[order[k]];
    const double here = value[order[k]];
    const double rise = k + 1 < order.size() ? value[order[k + 1]] - here : heat / behind;
    const double to = here + (std::abs(behind * rise) < std::abs(heat) ? rise : heat / behind);
    heat = std::abs(behind * rise) < std::abs(heat) ? heat - behind * rise : 0.0;
    for (std::size_t one = 0; one <= k; ++one) {
      value[order[one]] = to;
    }
  }
}

}  // namespace

template <int Dim>
HeatFields<Dim>::HeatFields(const HeatProblem<Dim>& problem,
                            const HeatCoefficients<Dim>& coefficients, bool with_surface,
                            const NodeFields<Dim>& fields, FindTouches touches)
    : grid_(problem.grid),
      fields_(fields),
      with_surface_(with_surface),
      nodes_(problem.grid, problem.shape, coefficients, with_surface, &fields),
      touches_(std::move(touches)),
      body_count_(problem.bodies.size()) {
  find_pairs(problem);
  find_conductivities(problem, coefficients);
}

/// Call body(number in the field, number in the grid), rows of a window in parallel.
template <int Dim>
template <class Body>
void HeatFields<Dim>::for_each_node(int field, const Body& body) const {
  const NodeField<Dim>& window = fields_[field];
  const Index row = window.grid.nodes(0), rows = window.grid.node_count() / row;
  parallel_for(rows, [&](Index k) {
    auto at = window.grid.node_at(k * row);
    for (int axis = 0; axis < Dim; ++axis) {
      at[axis] += window.corner[axis];
    }
    const Index here = window.offset + k * row, there = grid_.node_index(at);
    for (Index i = 0; i < row; ++i) {
      body(here + i, there + i);
    }
  });
}

template <int Dim>
void HeatFields<Dim>::project(const Points& points, const CellOrder<Dim>& order,
                              const double* capacity, const double* carried, const double* gradient,
                              PointGridTransfer<Dim>& whole) {
  nodes_.project(points, order, capacity, carried, gradient);
  whole.clear(order);
  count_.assign(static_cast<std::size_t>(grid_.node_count()), 0);
  for (int field = 0; field < fields_.count(); ++field) {
    for_each_node(field, [&](Index here, Index there) {
      const double own = nodes_.capacity[here];
      if (!(own > 0.0)) {
        return;
      }
      const double share = own / (whole.capacity[there] + own);
      whole.temperature[there] += share * (nodes_.temperature[here] - whole.temperature[there]);
      whole.capacity[there] += own;
      ++count_[there];
      if (with_surface_) {
        whole.sums.fraction[there] += nodes_.sums.fraction[here];
        whole.sums.area_vector[there] += nodes_.sums.area_vector[here];
      }
    });
  }
}

template <int Dim>
void HeatFields<Dim>::conduct(const Points& points, const CellOrder<Dim>& order, const Step& step,
                              PointGridTransfer<Dim>& whole) {
  find_beyond(step);
  for (BeyondNode& beyond : beyond_) {
    const double follows = following(beyond, nodes_.temperature);
    beyond.apart = nodes_.temperature[beyond.node] - follows;
    nodes_.temperature[beyond.node] = follows;
  }
  nodes_.conduct(points, order);
  for (const BeyondNode& beyond : beyond_) {
    nodes_.temperature[beyond.node] += beyond.apart;
  }
  for (int field = 0; field < fields_.count(); ++field) {
    for_each_node(field, [&](Index here, Index there) {
      if (nodes_.capacity[here] > 0.0) {
        whole.rate[there] += nodes_.rate[here];
      }
    });
  }
}

template <int Dim>
void HeatFields<Dim>::solve(const Step& step, const PointGridTransfer<Dim>& whole) {
  for (int field = 0; field < fields_.count(); ++field) {
    for_each_node(field, [&](Index here, Index there) {
      const double own = nodes_.capacity[here];
      if (own > 0.0) {
        nodes_.increment[here] =
            count_[there] == 1 ? whole.increment[there] : step.size * nodes_.rate[here] / own;
      }
    });
  }
  share_out(whole);
  exchange(step);
}

/// What others gave the nodes that fields share.
template <int Dim>
void HeatFields<Dim>::share_out(const PointGridTransfer<Dim>& whole) {
  std::vector<Index> number;
  std::vector<double> after, capacity;
  for (Index node = 0; node < grid_.node_count(); ++node) {
    if (count_[node] < 2) {
      continue;
    }
    number.clear();
    after.clear();
    capacity.clear();
    double heat = whole.capacity[node] * whole.increment[node], size = 0.0;
    for (int field = 0; field < fields_.count(); ++field) {
      const Index here = fields_.node_in(field, node);
      if (here >= 0 && nodes_.capacity[here] > 0.0) {
        number.push_back(here);
        capacity.push_back(nodes_.capacity[here]);
        after.push_back(nodes_.temperature[here] + nodes_.increment[here]);
        heat -= nodes_.capacity[here] * nodes_.increment[here];
        size += std::abs(nodes_.capacity[here] * nodes_.increment[here]);
      }
    }
    if (std::abs(heat) <= 1e-14 * size) {
      continue;  // rounding
    }
    level(after, capacity, heat);
    for (std::size_t k = 0; k < number.size(); ++k) {
      nodes_.increment[number[k]] = after[k] - nodes_.temperature[number[k]];
    }
  }
}

template <int Dim>
std::vector<std::vector<std::size_t>> HeatFields<Dim>::bodies() const {
  std::vector<std::vector<std::size_t>> all(static_cast<std::size_t>(fields_.count()));
  for (std::size_t body = 0; body < body_count_; ++body) {
    all[static_cast<std::size_t>(fields_.index_of(static_cast<Index>(body)))].push_back(body);
  }
  return all;
}

template <int Dim>
std::vector<std::pair<std::string, double>> HeatFields<Dim>::diagnostics() const {
  std::vector<std::pair<std::string, double>> all;
  for (const Pair& pair : pairs_) {
    all.emplace_back(pair.name, pair.heat);
  }
  return all;
}

template <int Dim>
void HeatFields<Dim>::save(Archive& archive) const {
  std::vector<double> heat;
  for (const Pair& pair : pairs_) {
    heat.push_back(pair.heat);
  }
  archive.write("heat/between_bodies", std::span<const double>(heat));
}

template <int Dim>
void HeatFields<Dim>::load(const Archive& archive) {
  std::vector<double> heat(pairs_.size());
  archive.read("heat/between_bodies", std::span<double>(heat));
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    pairs_[k].heat = heat[k];
  }
}

template class HeatFields<1>;
template class HeatFields<2>;
template class HeatFields<3>;

}  // namespace lapilli
