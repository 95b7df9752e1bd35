#include "lapilli/mpm/heat/conditions/prescribed_temperature.hpp"

namespace lapilli {

void PrescribedTemperature::find_exchange(const ExchangeSites& sites,
                                          const Exchange& exchange) const {
  for (std::size_t k = 0; k < sites.state.size(); ++k) {
    exchange.coefficient[k] = sites.hold[k] * (sites.weight.empty() ? 1.0 : sites.weight[k]);
  }
  value.evaluate_mean(sites.position, sites.state, sites.begin, sites.end, exchange.target);
  finish_linear(exchange);
}

}  // namespace lapilli
