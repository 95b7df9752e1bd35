#include "lapilli/core/value_over_step.hpp"

#include <algorithm>

namespace lapilli {
namespace {

/// Integral of the straight line through (t0, v0) and (t1, v1) over its part in [from, to].
double integral_between(double t0, double v0, double t1, double v1, double from, double to) {
  const double a = std::max(t0, from), b = std::min(t1, to);
  if (!(b > a)) {
    return 0.0;
  }
  const double slope = (v1 - v0) / (t1 - t0);
  return (b - a) * (v0 + slope * (0.5 * (a + b) - t0));
}

}  // namespace

double mean_over(const Table& table, double from, double to) {
  if (!(to > from)) {
    return table.at(from);
  }
  const auto& [times, values] = table;
  double sum = values.front() * std::max(0.0, std::min(to, times.front()) - from) +
               values.back() * std::max(0.0, to - std::max(from, times.back()));
  const auto first = std::upper_bound(times.begin(), times.end(), from) - times.begin();
  for (auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(first, 1)); k < times.size();
       ++k) {
    if (times[k - 1] >= to) {
      break;
    }
    if (times[k] > times[k - 1]) {
      sum += integral_between(times[k - 1], values[k - 1], times[k], values[k], from, to);
    }
  }
  return sum / (to - from);
}

double mean_over(const Value& value, double from, double to) {
  const auto* table = std::get_if<Table>(&value.form());
  return table != nullptr ? mean_over(*table, from, to) : value.at(from);
}

void evaluate_over(const Value& value, std::span<const Vec3> position,
                   std::span<const double> state, double from, double to,
                   std::span<double> values) {
  if (value.is_function()) {
    value.evaluate(position, state, 0.5 * (from + to), values);
  } else {
    std::fill(values.begin(), values.end(), mean_over(value, from, to));
  }
}

bool jumps_within(const Value& value, double from, double to) {
  const auto* table = std::get_if<Table>(&value.form());
  if (table == nullptr) {
    return false;
  }
  const auto& times = table->times;
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (times[k] == times[k - 1] && times[k] >= from && times[k] < to &&
        table->values[k] != table->values[k - 1]) {
      return true;
    }
  }
  return false;
}

}  // namespace lapilli
