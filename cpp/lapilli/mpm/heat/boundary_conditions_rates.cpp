#include <algorithm>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/boundary_conditions.hpp"

namespace lapilli {
namespace {

/// Of a condition between absolute temperatures: nodes of the band may lie below their zero.
void count_from_zero(double zero, std::span<double> state, std::span<double> target) {
  for (std::size_t k = 0; k < state.size(); ++k) {
    state[k] = std::max(state[k] - zero, 0.0);
    target[k] -= zero;
  }
}

}  // namespace

template <int Dim>
void BoundaryConditions<Dim>::evaluate(std::span<const double> temperature, double begin,
                                       double end) {
  evaluate_between(temperature, begin, end, Slope::tangent);
}

template <int Dim>
void BoundaryConditions<Dim>::evaluate_over(std::span<const double> temperature, double begin,
                                            double end) {
  evaluate_between(temperature, begin, end, Slope::secant);
}

template <int Dim>
void BoundaryConditions<Dim>::evaluate_between(std::span<const double> temperature, double begin,
                                               double end, Slope wanted) {
  const bool absolute = any_needs_absolute(laws_);
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    Nodes& n = nodes_[law];
    read_states(n, temperature);
    target_.resize(n.node.size());
    Exchange exchange{n.rate, n.slope, target_, {}};
    if (wanted == Slope::tangent) {
      coefficient_.resize(n.node.size());
      exchange.coefficient = coefficient_;
      exchange.tangent = n.slope;
    }
    find_exchange(laws_[law], {n.position, n.state, n.conductance, n.area, begin, end, zero_},
                  exchange);
    if (surroundings_of(laws_[law]) == nullptr) {
      continue;  // the flux is the rate
    }
    if (absolute) {
      require_absolute(law, target_);
    }
    if (needs_absolute(laws_[law])) {
      count_from_zero(zero_, n.state, target_);
    }
    add_exchange(exchange, n.state);
    find_own_slopes(n, exchange.coefficient);
  }
}

/// The temperature at the node, or at the probe of a held temperature.
template <int Dim>
void BoundaryConditions<Dim>::read_states(Nodes& n, std::span<const double> temperature) const {
  constexpr std::size_t corners = 1 << Dim;
  const bool has_probes = !n.probe.empty();
  for (std::size_t k = 0; k < n.node.size(); ++k) {
    if (!has_probes) {
      n.state[k] = temperature[n.node[k]];
      continue;
    }
    n.state[k] = 0.0;
    for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
      n.state[k] += n.probe[c].second * temperature[n.probe[c].first];
    }
  }
}

/// Of a probe, what the node itself has in it; the rest couples it to others.
template <int Dim>
void BoundaryConditions<Dim>::find_own_slopes(Nodes& n, std::span<const double> coefficient) const {
  constexpr std::size_t corners = 1 << Dim;
  for (std::size_t k = 0; k * corners < n.probe.size(); ++k) {
    const double conductance = coefficient[k];
    n.slope[k] = 0.0;
    for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
      n.slope[k] += n.probe[c].first == n.node[k] ? conductance * n.probe[c].second : 0.0;
    }
  }
}

template <int Dim>
void BoundaryConditions<Dim>::require_absolute(std::size_t law,
                                               std::span<const double> values) const {
  for (const double value : values) {
    if (value < zero_) {
      throw RunError(message("heat: ", name_of_law(laws_[law], law), " gave ", value,
                             ", below absolute zero at ", zero_,
                             ": temperatures under radiation are absolute"));
    }
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                            \
  template void BoundaryConditions<Dim>::evaluate(std::span<const double>, double, double); \
  template void BoundaryConditions<Dim>::evaluate_over(std::span<const double>, double, double);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
