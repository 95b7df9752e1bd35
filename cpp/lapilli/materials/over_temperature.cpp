#include "lapilli/materials/over_temperature.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

double TemperatureTable::at(double temperature) const {
  const auto after = std::upper_bound(temperatures.begin(), temperatures.end(), temperature);
  if (after == temperatures.begin()) {
    return values.front();
  }
  if (after == temperatures.end()) {
    return values.back();
  }
  const auto k = static_cast<std::size_t>(after - temperatures.begin());
  const double share =
      (temperature - temperatures[k - 1]) / (temperatures[k] - temperatures[k - 1]);
  return values[k - 1] + share * (values[k] - values[k - 1]);
}

double TemperatureTable::largest() const { return *std::max_element(values.begin(), values.end()); }

double TemperatureTable::least() const { return *std::min_element(values.begin(), values.end()); }

std::string mistake_in(const TemperatureTable& table) {
  const auto& at = table.temperatures;
  if (at.empty()) {
    return "is a table without temperatures";
  }
  if (at.size() != table.values.size()) {
    return message("needs as many values as temperatures, got ", table.values.size(), " and ",
                   at.size());
  }
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (!std::isfinite(at[k]) || !std::isfinite(table.values[k])) {
      return message("must be finite, got ", table.values[k], " at ", at[k]);
    }
    if (k > 0 && !(at[k] > at[k - 1])) {
      return message("needs temperatures that rise, got ", at[k], " after ", at[k - 1]);
    }
  }
  return "";
}

}  // namespace lapilli
