#include "lapilli/mpm/heat/conditions/radiation.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {

double Radiation::largest_coefficient(double hottest, double zero) const {
  return 4.0 * emissivity.largest() * stefan_boltzmann *
         std::pow(std::max(hottest, ambient.largest() - zero), 3);
}

void Radiation::find_exchange(const ExchangeSites& sites, const Exchange& exchange) const {
  fill_weighted(emissivity, sites, exchange.coefficient);
  fill_ambient(emissivity, ambient, 4, sites, exchange.target);
  std::ranges::fill(exchange.flux, 0.0);
  const bool asks_tangent = !exchange.tangent.empty();
  for (std::size_t k = 0; k < sites.state.size(); ++k) {
    const double factor = exchange.coefficient[k] * stefan_boltzmann;
    const double own = std::max(sites.state[k] - sites.zero, 0.0);
    const double far = exchange.target[k] - sites.zero;
    const double secant = factor * (far * far + own * own) * (far + own);
    exchange.coefficient[k] = secant;
    if (asks_tangent) {
      exchange.tangent[k] = 4.0 * factor * own * own * own;
    }
  }
}

}  // namespace lapilli
