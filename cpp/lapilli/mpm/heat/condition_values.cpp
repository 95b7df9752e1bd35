#include "lapilli/mpm/heat/condition_values.hpp"

#include <algorithm>

namespace lapilli {

std::vector<const Value*> values_of(const HeatBoundary& condition) {
  if (const auto* convection = std::get_if<Convection>(&condition)) {
    return {&convection->coefficient, &convection->ambient};
  }
  if (const auto* radiation = std::get_if<Radiation>(&condition)) {
    return {&radiation->emissivity, &radiation->ambient};
  }
  const auto* flux = std::get_if<Flux>(&condition);
  return {flux != nullptr ? &flux->value : &std::get<PrescribedTemperature>(condition).value};
}

bool has_function(const HeatBoundary& condition) {
  return std::ranges::any_of(values_of(condition),
                             [](const Value* value) { return value->is_function(); });
}

}  // namespace lapilli
