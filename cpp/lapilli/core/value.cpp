#include "lapilli/core/value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace lapilli {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

double between(const Table& table, std::size_t k, double time) {
  const auto& [times, values] = table;
  const double share = (time - times[k - 1]) / (times[k] - times[k - 1]);
  return values[k - 1] + share * (values[k] - values[k - 1]);
}

}  // namespace

bool Table::is_ordered() const {
  for (std::size_t k = 1; k < times.size(); ++k) {
    const bool jumps = times[k] == times[k - 1] && (k < 2 || times[k] > times[k - 2]);
    if (!(times[k] > times[k - 1] || jumps)) {
      return false;
    }
  }
  return true;
}

double Table::at(double time) const {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  if (after == times.begin()) {
    return values.front();
  }
  if (after == times.end()) {
    return values.back();
  }
  return between(*this, static_cast<std::size_t>(after - times.begin()), time);
}

double Table::before(double time) const {
  const auto next = std::lower_bound(times.begin(), times.end(), time);
  if (next == times.begin()) {
    return values.front();
  }
  if (next == times.end()) {
    return values.back();
  }
  return between(*this, static_cast<std::size_t>(next - times.begin()), time);
}

double Table::mean(double begin, double end) const {
  if (!(end > begin)) {
    return at(begin);
  }
  // About the first value: what is constant comes out to the last digit.
  const double base = at(begin);
  double time = begin, value = base, sum = 0.0;
  auto next = std::upper_bound(times.begin(), times.end(), begin);
  for (; next != times.end() && *next < end; ++next) {
    const double reached = values[static_cast<std::size_t>(next - times.begin())];
    sum += (*next - time) * (0.5 * (value + reached) - base);
    time = *next;
    value = reached;
  }
  sum += (end - time) * (0.5 * (value + before(end)) - base);
  return base + sum / (end - begin);
}

double Table::next_jump(double time) const {
  for (auto next = std::upper_bound(times.begin(), times.end(), time); next != times.end();
       ++next) {
    if (next + 1 != times.end() && next[1] == next[0]) {
      return *next;
    }
  }
  return never;
}

double Table::next_entry(double time) const {
  const auto next = std::upper_bound(times.begin(), times.end(), time);
  return next != times.end() ? *next : never;
}

double Value::at(double time) const {
  if (const auto* constant = std::get_if<double>(&form_)) {
    return *constant;
  }
  const auto* table = std::get_if<Table>(&form_);
  return table != nullptr ? table->at(time) : 0.0;
}

double Value::before(double time) const {
  const auto* table = std::get_if<Table>(&form_);
  return table != nullptr ? table->before(time) : at(time);
}

double Value::mean(double begin, double end) const {
  const auto* table = std::get_if<Table>(&form_);
  return table != nullptr ? table->mean(begin, end) : at(begin);
}

double Value::next_jump(double time) const {
  const auto* table = std::get_if<Table>(&form_);
  return table != nullptr ? table->next_jump(time) : never;
}

double Value::next_entry(double time) const {
  const auto* table = std::get_if<Table>(&form_);
  return table != nullptr ? table->next_entry(time) : never;
}

double Value::last_jump(double time) const {
  double last = 0.0;
  for (double jump = next_jump(0.0); jump <= time; jump = next_jump(jump)) {
    last = jump;
  }
  return last;
}

double Value::last_entry(double time) const {
  const auto* table = std::get_if<Table>(&form_);
  if (table == nullptr) {
    return -never;
  }
  const auto later = std::upper_bound(table->times.begin(), table->times.end(), time);
  return later == table->times.begin() ? 0.0 : std::max(0.0, *std::prev(later));
}

double Value::largest() const {
  if (const auto* table = std::get_if<Table>(&form_)) {
    return *std::max_element(table->values.begin(), table->values.end());
  }
  return is_function() ? never : at(0.0);
}

double Value::least() const {
  if (const auto* table = std::get_if<Table>(&form_)) {
    return *std::min_element(table->values.begin(), table->values.end());
  }
  return is_function() ? -never : at(0.0);
}

void Value::evaluate(std::span<const Vec3> position, std::span<const double> state, double time,
                     std::span<double> values) const {
  if (const auto* function = std::get_if<ArrayFunction>(&form_)) {
    (*function)(position, state, time, values);
  } else {
    std::fill(values.begin(), values.end(), at(time));
  }
}

void Value::evaluate_mean(std::span<const Vec3> position, std::span<const double> state,
                          double begin, double end, std::span<double> values) const {
  if (is_function()) {
    evaluate(position, state, begin + 0.5 * (end - begin), values);
  } else {
    std::fill(values.begin(), values.end(), mean(begin, end));
  }
}

double mean_of_product(std::initializer_list<const Value*> values, double begin, double end,
                       const std::function<double(double)>& product) {
  if (!(end > begin)) {
    return product(begin);
  }
  std::vector<double> edges{begin, end};
  for (const Value* value : values) {
    if (const auto* table = std::get_if<Table>(&value->form())) {
      const auto from = std::upper_bound(table->times.begin(), table->times.end(), begin);
      const auto to = std::lower_bound(from, table->times.end(), end);
      edges.insert(edges.end(), from, to);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  // Gauss's rule of three points, exact to the fifth degree, about the first value.
  const double reach = std::sqrt(0.6);
  const std::array<double, 3> place{0.0, -reach, reach}, weight{4.0 / 9, 5.0 / 18, 5.0 / 18};
  const double base = product(0.5 * (edges[0] + edges[1]));
  double sum = 0.0;
  for (std::size_t k = 1; k < edges.size(); ++k) {
    const double half = 0.5 * (edges[k] - edges[k - 1]), middle = edges[k - 1] + half;
    for (std::size_t q = 0; q < place.size(); ++q) {
      sum += 2.0 * half * weight[q] * (product(middle + place[q] * half) - base);
    }
  }
  return base + sum / (end - begin);
}

}  // namespace lapilli
