#include "lapilli/mpm/heat/conditions/heat_boundary.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/span_of_shape.hpp"
#include "lapilli/mpm/heat/conditions/condition_parts.hpp"

namespace lapilli {
namespace {

template <class List>
constexpr bool are_whole = false;
template <class... Conditions>
constexpr bool are_whole<std::variant<Conditions...>> = (is_whole_condition<Conditions>() && ...);
static_assert(are_whole<HeatBoundary>);

}  // namespace

void require_surface(const std::vector<HeatBoundary>& conditions, std::size_t index,
                     bool is_there) {
  if (is_there) {
    return;
  }
  const Shape* region = region_of(conditions[index]);
  require(false, "heat.boundaries.", index, " (", name_of_law(conditions[index], index),
          ") selects no surface: ",
          region != nullptr ? message("its region", span_of_shape(*region),
                                      " covers none that an earlier condition left")
                            : std::string("earlier conditions took all of it"));
}

std::vector<const char*> modelled_by(std::span<const HeatBoundary> conditions) {
  std::vector<const char*> all;
  for (std::size_t kind = 0; kind < std::variant_size_v<HeatBoundary>; ++kind) {
    const auto one = std::ranges::find_if(
        conditions, [&](const HeatBoundary& condition) { return condition.index() == kind; });
    if (one != conditions.end()) {
      all.push_back(std::visit([](const auto& found) { return found.modelled; }, *one));
    }
  }
  return all;
}

std::vector<const Value*> values_of(const HeatBoundary& condition) {
  std::vector<const Value*> values;
  std::visit(
      [&](const auto& one) {
        for_each_value(one, [&](const Key&, const Value& value) { values.push_back(&value); });
      },
      condition);
  return values;
}

std::vector<Value*> values_of(HeatBoundary& condition) {
  std::vector<Value*> values;
  std::visit(
      [&](auto& one) {
        for_each_value(one, [&](const Key&, Value& value) { values.push_back(&value); });
      },
      condition);
  return values;
}

bool has_function(const HeatBoundary& condition) {
  return std::ranges::any_of(values_of(condition),
                             [](const Value* value) { return value->is_function(); });
}

const Value* surroundings_of(const HeatBoundary& condition) {
  return std::visit([](const auto& one) { return one.surroundings(); }, condition);
}

std::string key_of_surroundings(const HeatBoundary& condition) {
  std::string name;
  std::visit(
      [&](const auto& one) {
        for_each_value(one, [&](const Key& key, const Value& value) {
          name = &value == one.surroundings() ? key.name : name;
        });
      },
      condition);
  return name;
}

bool holds_temperature(const HeatBoundary& condition) {
  return std::visit([](const auto& one) { return one.holds_temperature; }, condition);
}

bool exchanges(const HeatBoundary& condition) {
  return surroundings_of(condition) != nullptr && !holds_temperature(condition);
}

bool needs_absolute(const HeatBoundary& condition) {
  return std::visit([](const auto& one) { return one.needs_absolute; }, condition);
}

bool any_needs_absolute(std::span<const HeatBoundary> conditions) {
  return std::ranges::any_of(conditions, needs_absolute);
}

bool is_linear(const HeatBoundary& condition) {
  return std::visit([](const auto& one) { return one.is_linear(); }, condition);
}

bool are_linear(std::span<const HeatBoundary> conditions) {
  return std::ranges::all_of(conditions,
                             [](const HeatBoundary& condition) { return is_linear(condition); });
}

bool is_uniform(const HeatBoundary& condition) {
  return is_linear(condition) && !has_function(condition);
}

const Value* given_coefficient(const HeatBoundary& condition) {
  return std::visit([](const auto& one) { return one.given_coefficient(); }, condition);
}

double largest_coefficient(const HeatBoundary& condition, double hottest, double zero) {
  return std::visit([&](const auto& one) { return one.largest_coefficient(hottest, zero); },
                    condition);
}

void find_exchange(const HeatBoundary& condition, const ExchangeSites& sites,
                   const Exchange& exchange) {
  std::visit([&](const auto& one) { one.find_exchange(sites, exchange); }, condition);
}

}  // namespace lapilli
