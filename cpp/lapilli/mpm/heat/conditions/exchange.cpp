#include "lapilli/mpm/heat/conditions/exchange.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lapilli/mpm/heat/conditions/ambient_over_step.hpp"

namespace lapilli {
namespace {

void fill_mean(const Value& value, const ExchangeSites& sites, std::span<double> filled) {
  value.evaluate_mean(sites.position, sites.state, sites.begin, sites.end, filled);
}

void weigh(const ExchangeSites& sites, std::span<double> values) {
  for (std::size_t k = 0; k < sites.weight.size(); ++k) {
    values[k] *= sites.weight[k];
  }
}

/// How much a function falls for every kelvin, where it does, by a difference from `now`.
void find_fall(const Value& function, const ExchangeSites& sites, std::span<const double> now,
               std::span<double> fall) {
  double span = 1.0;
  for (const double state : sites.state) {
    span = std::max(span, std::abs(state));
  }
  const double rise = 1e-6 * span;
  std::vector<double> warmer(sites.state.begin(), sites.state.end());
  for (double& state : warmer) {
    state += rise;
  }
  function.evaluate_mean(sites.position, warmer, sites.begin, sites.end, fall);
  for (std::size_t k = 0; k < fall.size(); ++k) {
    fall[k] = std::max(0.0, (now[k] - fall[k]) / rise);
  }
}

}  // namespace

void add_exchange(const Exchange& exchange, std::span<const double> state) {
  for (std::size_t k = 0; k < state.size(); ++k) {
    exchange.flux[k] += exchange.coefficient[k] * (exchange.target[k] - state[k]);
  }
}

void fill_weighted(const Value& value, const ExchangeSites& sites, std::span<double> filled) {
  fill_mean(value, sites, filled);
  weigh(sites, filled);
}

void fill_ambient(const Value& coefficient, const Value& ambient, int power,
                  const ExchangeSites& sites, std::span<double> filled) {
  if (ambient.is_function()) {
    fill_mean(ambient, sites, filled);
    return;
  }
  std::ranges::fill(filled,
                    ambient_over(coefficient, ambient, power, sites.zero, sites.begin, sites.end));
}

void find_flux(const Value& value, const ExchangeSites& sites, const Exchange& exchange) {
  fill_mean(value, sites, exchange.flux);
  if (value.is_function()) {
    find_fall(value, sites, exchange.flux, exchange.coefficient);
    weigh(sites, exchange.coefficient);
  } else {
    std::ranges::fill(exchange.coefficient, 0.0);
  }
  weigh(sites, exchange.flux);
  std::ranges::copy(exchange.coefficient.first(exchange.tangent.size()), exchange.tangent.begin());
}

void finish_linear(const Exchange& exchange) {
  std::ranges::fill(exchange.flux, 0.0);
  std::ranges::copy(exchange.coefficient.first(exchange.tangent.size()), exchange.tangent.begin());
}

}  // namespace lapilli
