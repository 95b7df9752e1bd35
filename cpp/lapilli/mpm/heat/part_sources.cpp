#include "lapilli/mpm/heat/part_sources.hpp"

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

#define LAPILLI_INSTANTIATE(Dim)                                                  \
  template double source_heat(const HeatPart<Dim>&, const std::vector<HeatBody>&, \
                              std::span<const double>, double, double, std::span<double>);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
