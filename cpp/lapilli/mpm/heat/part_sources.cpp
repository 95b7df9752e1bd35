#include "lapilli/mpm/heat/part_sources.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {

template <int Dim>
double source_heat(const HeatPart<Dim>& part, const std::vector<HeatBody>& bodies,
                   std::span<const double> temperature, double begin, double size,
                   std::span<double> heat) {
  double sum = 0.0;
  for (const auto& own : part.sources) {
    std::vector<double> state, rate(own.place.size());
    for (const Index place : own.place) {
      state.push_back(temperature[place]);
    }
    bodies[own.body].source.evaluate_mean(own.position, state, begin, begin + size, rate);
    for (std::size_t k = 0; k < rate.size(); ++k) {
      heat[own.place[k]] += size * rate[k] * own.volume[k];
      sum += size * rate[k] * own.volume[k];
    }
  }
  part.followers.restrict_to_leaders(heat);
  return sum;
}

template <int Dim>
SourceRates source_rates(const HeatPart<Dim>& part, const std::vector<HeatBody>& bodies,
                         std::span<const double> temperature, double begin, double end) {
  SourceRates all;
  all.power.assign(temperature.size(), 0.0);
  for (const auto& own : part.sources) {
    const Value& source = bodies[own.body].source;
    std::vector<double> state, power(own.place.size()), warmer(own.place.size());
    double span = 1.0;
    for (const Index place : own.place) {
      state.push_back(temperature[place]);
      span = std::max(span, std::abs(state.back()));
    }
    source.evaluate_mean(own.position, state, begin, end, power);
    for (std::size_t k = 0; k < power.size(); ++k) {
      all.power[own.place[k]] += power[k] * own.volume[k];
    }
    if (!source.is_function()) {
      continue;
    }
    const double rise = 1e-6 * span;
    for (double& value : state) {
      value += rise;
    }
    source.evaluate_mean(own.position, state, begin, end, warmer);
    all.fall.resize(temperature.size(), 0.0);
    for (std::size_t k = 0; k < power.size(); ++k) {
      all.fall[own.place[k]] += (power[k] - warmer[k]) / rise * own.volume[k];
    }
  }
  part.followers.restrict_to_leaders(all.power);
  if (!all.fall.empty()) {
    part.followers.restrict_to_leaders(all.fall);
  }
  return all;
}

#define LAPILLI_INSTANTIATE(Dim)                                                           \
  template double source_heat(const HeatPart<Dim>&, const std::vector<HeatBody>&,          \
                              std::span<const double>, double, double, std::span<double>); \
  template SourceRates source_rates(const HeatPart<Dim>&, const std::vector<HeatBody>&,    \
                                    std::span<const double>, double, double);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
