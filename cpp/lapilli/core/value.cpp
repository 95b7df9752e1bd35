#include "lapilli/core/value.hpp"

#include <algorithm>

namespace lapilli {

double Table::at(double time) const {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  if (after == times.begin()) {
    return values.front();
  }
  if (after == times.end()) {
    return values.back();
  }
  const auto k = static_cast<std::size_t>(after - times.begin());
  const double share = (time - times[k - 1]) / (times[k] - times[k - 1]);
  return values[k - 1] + share * (values[k] - values[k - 1]);
}

double Value::at(double time) const {
  if (const auto* constant = std::get_if<double>(&form_)) {
    return *constant;
  }
  if (const auto* table = std::get_if<Table>(&form_)) {
    return table->at(time);
  }
  return 0.0;
}

void Value::evaluate(std::span<const Vec3> position, std::span<const double> state, double time,
                     std::span<double> values) const {
  if (const auto* function = std::get_if<ArrayFunction>(&form_)) {
    (*function)(position, state, time, values);
  } else {
    std::fill(values.begin(), values.end(), at(time));
  }
}

}  // namespace lapilli
