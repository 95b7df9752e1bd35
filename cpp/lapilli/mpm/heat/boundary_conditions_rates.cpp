#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/ambient_over_step.hpp"
#include "lapilli/mpm/heat/boundary_conditions.hpp"

namespace lapilli {

template <int Dim>
void BoundaryConditions<Dim>::read_states(std::size_t law, std::span<const double> temperature) {
  constexpr std::size_t corners = 1 << Dim;
  Nodes& n = nodes_[law];
  const bool held = std::holds_alternative<PrescribedTemperature>(laws_[law]);
  for (std::size_t k = 0; k < n.node.size(); ++k) {
    if (!held) {
      n.state[k] = temperature[n.node[k]];
      continue;
    }
    n.state[k] = 0.0;
    for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
      n.state[k] += n.probe[c].second * temperature[n.probe[c].first];
    }
  }
}

template <int Dim>
void BoundaryConditions<Dim>::fill(const Value& value, const Nodes& nodes,
                                   std::vector<double>& values) const {
  value.evaluate_mean(nodes.position, nodes.state, begin_, end_, values);
}

template <int Dim>
void BoundaryConditions<Dim>::fill_ambient(const Value& coefficient, const Value& ambient,
                                           int power, const Nodes& nodes,
                                           std::vector<double>& values) const {
  if (ambient.is_function()) {
    fill(ambient, nodes, values);
    return;
  }
  std::fill(values.begin(), values.end(),
            ambient_over(coefficient, ambient, power, zero_, begin_, end_));
}

template <int Dim>
void BoundaryConditions<Dim>::evaluate(std::span<const double> temperature, double begin,
                                       double end) {
  secant_ = false;
  evaluate_between(temperature, begin, end);
}

template <int Dim>
void BoundaryConditions<Dim>::evaluate_over(std::span<const double> temperature, double begin,
                                            double end) {
  secant_ = true;
  evaluate_between(temperature, begin, end);
}

template <int Dim>
void BoundaryConditions<Dim>::evaluate_between(std::span<const double> temperature, double begin,
                                               double end) {
  begin_ = begin;
  end_ = end;
  const bool absolute = has_radiation();
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    read_states(law, temperature);
    Nodes& n = nodes_[law];
    first_.resize(n.node.size());
    second_.resize(n.node.size());
    if (const auto* flux = std::get_if<Flux>(&laws_[law])) {
      evaluate_flux(*flux, n);
    } else if (const auto* convection = std::get_if<Convection>(&laws_[law])) {
      evaluate_convection(*convection, n);
    } else if (const auto* radiation = std::get_if<Radiation>(&laws_[law])) {
      evaluate_radiation(*radiation, n);
    } else {
      fill(std::get<PrescribedTemperature>(laws_[law]).value, n, second_);
      evaluate_held(n);
    }
    if (absolute && !std::holds_alternative<Flux>(laws_[law])) {
      require_absolute(law, second_);
    }
  }
}

template <int Dim>
void BoundaryConditions<Dim>::evaluate_flux(const Flux& law, Nodes& n) {
  fill(law.value, n, first_);
  std::fill(n.slope.begin(), n.slope.end(), 0.0);
  if (law.value.is_function()) {
    // The slope of a function, by a difference: a flux that falls with the temperature is taken at
    // the end of the step like convection.
    double span = 1.0;
    for (const double state : n.state) {
      span = std::max(span, std::abs(state));
    }
    const double rise = 1e-6 * span;
    std::vector<double> warmer(n.state);
    for (double& state : warmer) {
      state += rise;
    }
    law.value.evaluate_mean(n.position, warmer, begin_, end_, second_);
    for (std::size_t k = 0; k < n.slope.size(); ++k) {
      n.slope[k] = n.area[k] * std::max(0.0, (first_[k] - second_[k]) / rise);
    }
  }
  for (std::size_t k = 0; k < n.rate.size(); ++k) {
    n.rate[k] = n.area[k] * first_[k];
  }
}

template <int Dim>
void BoundaryConditions<Dim>::evaluate_convection(const Convection& law, Nodes& n) {
  fill(law.coefficient, n, first_);
  fill_ambient(law.coefficient, law.ambient, 1, n, second_);
  for (std::size_t k = 0; k < n.rate.size(); ++k) {
    n.slope[k] = n.area[k] * first_[k];
    n.rate[k] = n.slope[k] * (second_[k] - n.state[k]);
  }
}

template <int Dim>
void BoundaryConditions<Dim>::evaluate_radiation(const Radiation& law, Nodes& n) {
  fill(law.emissivity, n, first_);
  fill_ambient(law.emissivity, law.ambient, 4, n, second_);
  for (std::size_t k = 0; k < n.rate.size(); ++k) {
    const double factor = n.area[k] * first_[k] * law.stefan_boltzmann;
    const double own = std::max(n.state[k] - zero_, 0.0), far = second_[k] - zero_;
    const double secant = factor * (far * far + own * own) * (far + own);
    n.rate[k] = secant * (far - own);
    n.slope[k] = secant_ ? secant : 4.0 * factor * own * own * own;
  }
}

template <int Dim>
void BoundaryConditions<Dim>::evaluate_held(Nodes& n) {
  constexpr std::size_t corners = 1 << Dim;
  for (std::size_t k = 0; k < n.rate.size(); ++k) {
    const double conductance = n.area[k] * n.conductance[k];
    n.slope[k] = 0.0;
    for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
      n.slope[k] += n.probe[c].first == n.node[k] ? conductance * n.probe[c].second : 0.0;
    }
    n.rate[k] = conductance * (second_[k] - n.state[k]);
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
