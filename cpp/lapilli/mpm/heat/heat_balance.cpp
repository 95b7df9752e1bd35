#include "lapilli/mpm/heat/heat_balance.hpp"

#include <algorithm>
#include <limits>

namespace lapilli {

void add_stored_heat(std::span<const double> capacity, std::span<const double> temperature,
                     Balance& balance) {
  double low = std::numeric_limits<double>::infinity(), high = -low, total = 0.0;
  for (std::size_t k = 0; k < capacity.size(); ++k) {
    if (capacity[k] > 0.0) {
      balance.stored += capacity[k] * temperature[k];
      total += capacity[k];
      low = std::min(low, temperature[k]);
      high = std::max(high, temperature[k]);
    }
  }
  balance.scale = total > 0.0 ? total * (high - low) : 0.0;
  balance.bar = 1e-6;  // measured: rounding, 1e-12 and less
}

template <int Dim>
std::vector<std::pair<std::string, double>> surface_diagnostics(const BoundaryConditions<Dim>& laws,
                                                                double negative_share) {
  if (laws.empty()) {
    return {};
  }
  double area = 0.0;
  for (const auto& nodes : laws.nodes()) {
    for (const double a : nodes.area) {
      area += a;
    }
  }
  return {{"surface_area", area},
          {"area_ratio", laws.area_ratios().farthest()},
          {"negative_area_share", negative_share}};
}

#define LAPILLI_INSTANTIATE(Dim)                                            \
  template std::vector<std::pair<std::string, double>> surface_diagnostics( \
      const BoundaryConditions<Dim>&, double);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
