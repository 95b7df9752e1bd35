// Nodes that a body reaches beyond the face it shares with another.
#include <algorithm>
#include <cmath>
#include <utility>

#include "lapilli/mpm/heat/heat_fields.hpp"

namespace lapilli {
namespace {

constexpr int farthest_line = 3;     // cells, of inner nodes
constexpr double behind = 0.5;       // cells, of inner nodes behind the face
constexpr double most_share = 2.0;   // of the temperature across; the rest takes from inner nodes
constexpr double least_biot = 2.0;   // conductance x cell / conductivity
constexpr double light = 1e-2;       // of the capacity of the node across
constexpr double least_share = 0.5;  // of its own capacity that a node keeps, whoever follows it

}  // namespace

template <int Dim>
void HeatFields<Dim>::find_conductivities(const HeatProblem<Dim>& problem,
                                          const HeatCoefficients<Dim>& coefficients) {
  for (const std::vector<std::size_t>& some : bodies()) {
    bool alike = !some.empty();
    for (const std::size_t body : some) {
      alike = alike && problem.bodies[body].material.conductivity ==
                           problem.bodies[some.front()].material.conductivity;
    }
    conductivity_.push_back(alike ? std::optional<Mat<Dim>>(coefficients.conductivity[some.front()])
                                  : std::nullopt);
  }
}

template <int Dim>
double HeatFields<Dim>::following(const BeyondNode& beyond,
                                  const std::vector<double>& values) const {
  double inner = 0.0;
  for (int k = 0; k < beyond.inner_count; ++k) {
    inner += beyond.weight[k] * values[beyond.inner[k]];
  }
  return beyond.share * values[beyond.across] + (1.0 - beyond.share) * inner;
}

/// The nodes around the first place on a line of the grid, from the node across the face into the
/// body, that lie all in the body; `reach` (m) of that place.
template <int Dim>
bool HeatFields<Dim>::find_inner(const BodyTouch& touch, BeyondNode& beyond, double& reach) const {
  const int field = beyond.of_first ? touch.first : touch.second;
  const Vec<Dim> inward = (beyond.of_first ? -1.0 : 1.0) * touch.normal.template head<Dim>();
  int main = 0;
  const double most = inward.cwiseAbs().maxCoeff(&main);
  if (!(most > 0.0)) {
    return false;
  }
  for (int line = 1; line <= farthest_line; ++line) {
    const Vec<Dim> off = line / most * inward;
    std::array<Index, Dim> base{};
    for (int axis = 0; axis < Dim; ++axis) {
      base[axis] = static_cast<Index>(axis == main ? std::round(off[axis]) : std::floor(off[axis]));
    }
    beyond.inner_count = 0;
    double sum = 0.0;
    bool all = (line / most - behind) * grid_.cell_size() >= std::abs(touch.beyond);
    for (int corner = 0; corner < (1 << Dim) && all; ++corner) {
      double weight = (corner >> main) % 2 == 0 ? 1.0 : 0.0;
      Index node = touch.node;
      for (int axis = 0; axis < Dim; ++axis) {
        const int up = (corner >> axis) % 2;
        node += (base[axis] + up) * grid_.node_stride(axis);
        if (axis != main) {
          const double rest = off[axis] - static_cast<double>(base[axis]);
          weight *= up == 1 ? rest : 1.0 - rest;
        }
      }
      if (weight < 1e-9) {
        continue;
      }
      const Index inner =
          node >= 0 && node < grid_.node_count() ? fields_.node_in(field, node) : -1;
      if (inner < 0 || nodes_.capacity[inner] < light * nodes_.capacity[beyond.across]) {
        continue;  // past the end of the face
      }
      all = is_beyond_[inner] == 0;
      beyond.inner[beyond.inner_count] = inner;
      beyond.weight[beyond.inner_count++] = weight;
      sum += weight;
    }
    if (all && sum > 0.5) {
      for (double& weight : beyond.weight) {
        weight /= sum;
      }
      reach = line * grid_.cell_size() / most;
      return true;
    }
  }
  return false;
}

/// W/(m K), of the fields of a touch, along its normal.
template <int Dim>
std::pair<double, double> HeatFields<Dim>::conductivities(const BodyTouch& touch) const {
  const Vec<Dim> normal = touch.normal.template head<Dim>();
  return {normal.dot(*conductivity_[touch.first] * normal),
          normal.dot(*conductivity_[touch.second] * normal)};
}

/// Bodies that conduct alike have one slope on both sides; beside a contact that resists more than
/// the way to it, slopes tell little, and the area that touches is known better than that which
/// nodes beyond the face conduct through.
template <int Dim>
bool HeatFields<Dim>::slopes_differ(const BodyTouch& touch, const Step& step) const {
  if (!conductivity_[touch.first] || !conductivity_[touch.second]) {
    return false;
  }
  const auto [first, second] = conductivities(touch);
  if (!(std::min(first, second) > 0.0) || std::abs(first / second - 1.0) < 1e-9) {
    return false;
  }
  const auto& given = pairs_[pair_of(touch)].conductance;
  return !given || given->mean(step.time, step.time + step.size) * grid_.cell_size() >
                       least_biot * std::min(first, second);
}

template <int Dim>
void HeatFields<Dim>::find_beyond(const Step& step) {
  beyond_.clear();
  level_.clear();
  is_beyond_.assign(nodes_.capacity.size(), 0);
  std::vector<std::pair<BeyondNode, const BodyTouch*>> found;
  for (const BodyTouch& touch : touches_()) {
    const Index a = fields_.node_in(touch.first, touch.node);
    const Index b = fields_.node_in(touch.second, touch.node);
    if (a < 0 || b < 0 || !(nodes_.capacity[a] > 0.0) || !(nodes_.capacity[b] > 0.0)) {
      continue;
    }
    if (!slopes_differ(touch, step)) {
      level_.push_back(&touch);
      continue;
    }
    BeyondNode beyond;
    beyond.of_first = touch.beyond < 0.0;
    beyond.node = beyond.of_first ? a : b;
    beyond.across = beyond.of_first ? b : a;
    beyond.pair = pair_of(touch);
    is_beyond_[beyond.node] = 1;
    found.emplace_back(beyond, &touch);
  }
  for (auto& [beyond, touch] : found) {
    double reach = 0.0;
    if (is_beyond_[beyond.across] != 0 || !find_inner(*touch, beyond, reach)) {
      level_.push_back(touch);
      continue;
    }
    const auto [first, second] = conductivities(*touch);
    const double own = beyond.of_first ? first : second, other = beyond.of_first ? second : first;
    const double depth = std::abs(touch->beyond);
    double resistance = (reach - depth) / own + depth / other;
    if (const auto& given = pairs_[beyond.pair].conductance) {
      resistance += 1.0 / given->mean(step.time, step.time + step.size);
    }
    beyond.share = std::min(most_share, reach / own / resistance);
    beyond_.push_back(beyond);
  }
  keep_capacities_positive();
}

/// Extrapolation takes capacity from inner nodes.
template <int Dim>
void HeatFields<Dim>::keep_capacities_positive() {
  led_capacity_.assign(nodes_.capacity.begin(), nodes_.capacity.end());
  const auto add = [&](const BeyondNode& beyond, double sign) {
    const double capacity = sign * nodes_.capacity[beyond.node];
    led_capacity_[beyond.across] += beyond.share * capacity;
    for (int k = 0; k < beyond.inner_count; ++k) {
      led_capacity_[beyond.inner[k]] += (1.0 - beyond.share) * beyond.weight[k] * capacity;
    }
  };
  for (const BeyondNode& beyond : beyond_) {
    add(beyond, 1.0);
  }
  for (BeyondNode& beyond : beyond_) {
    for (int k = 0; k < beyond.inner_count && beyond.share > 1.0; ++k) {
      if (led_capacity_[beyond.inner[k]] < least_share * nodes_.capacity[beyond.inner[k]]) {
        add(beyond, -1.0);
        beyond.share = 1.0;
        add(beyond, 1.0);
      }
    }
  }
}

/// At the end of the step: what a node beyond the face conducts goes across it, what it holds to
/// those that it follows.
template <int Dim>
void HeatFields<Dim>::hand_to_leaders(const Step& step) {
  if (beyond_.empty()) {
    return;
  }
  const auto heat_of = [&](const BeyondNode& beyond) {
    const double conducted = step.size * nodes_.rate[beyond.node];
    const double held =
        nodes_.capacity[beyond.node] * (nodes_.increment[beyond.node] + beyond.apart) - conducted;
    return std::pair(conducted, held);
  };
  led_heat_.assign(nodes_.capacity.size(), 0.0);
  for (const BeyondNode& beyond : beyond_) {
    const auto [conducted, held] = heat_of(beyond);
    led_heat_[beyond.across] += conducted + beyond.share * held;
    for (int k = 0; k < beyond.inner_count; ++k) {
      led_heat_[beyond.inner[k]] += (1.0 - beyond.share) * beyond.weight[k] * held;
    }
  }
  std::vector<double> rise = nodes_.increment;
  const auto take = [&](Index leader) {
    rise[leader] = (nodes_.capacity[leader] * nodes_.increment[leader] + led_heat_[leader]) /
                   led_capacity_[leader];
  };
  for (const BeyondNode& beyond : beyond_) {
    take(beyond.across);
    for (int k = 0; k < beyond.inner_count; ++k) {
      take(beyond.inner[k]);
    }
  }
  for (const BeyondNode& beyond : beyond_) {
    const auto [conducted, held] = heat_of(beyond);
    const double passed =
        conducted + beyond.share * (held - nodes_.capacity[beyond.node] * rise[beyond.across]);
    pairs_[beyond.pair].heat += beyond.of_first ? passed : -passed;
    rise[beyond.node] = following(beyond, rise) - beyond.apart;
  }
  nodes_.increment.swap(rise);
}

#define LAPILLI_INSTANTIATE(Dim)                                                                   \
  template void HeatFields<Dim>::find_conductivities(const HeatProblem<Dim>&,                      \
                                                     const HeatCoefficients<Dim>&);                \
  template double HeatFields<Dim>::following(const BeyondNode&, const std::vector<double>&) const; \
  template bool HeatFields<Dim>::find_inner(const BodyTouch&, BeyondNode&, double&) const;         \
  template std::pair<double, double> HeatFields<Dim>::conductivities(const BodyTouch&) const;      \
  template bool HeatFields<Dim>::slopes_differ(const BodyTouch&, const Step&) const;               \
  template void HeatFields<Dim>::find_beyond(const Step&);                                         \
  template void HeatFields<Dim>::keep_capacities_positive();                                       \
  template void HeatFields<Dim>::hand_to_leaders(const Step&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
