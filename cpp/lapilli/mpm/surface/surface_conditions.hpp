#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// The region of a boundary condition, null when it takes what is left.
template <class... Kinds>
const Shape* region_of(const std::variant<Kinds...>& condition) {
  return std::visit([](const auto& one) { return one.region ? &*one.region : nullptr; }, condition);
}

template <class Condition>
std::vector<const Shape*> regions_of(const std::vector<Condition>& conditions) {
  std::vector<const Shape*> regions;
  for (const Condition& condition : conditions) {
    regions.push_back(region_of(condition));
  }
  return regions;
}

/// Throws std::invalid_argument where a region cannot be.
template <class Condition>
void check_regions(const std::vector<Condition>& conditions, int dimension) {
  for (const Condition& condition : conditions) {
    if (const Shape* region = region_of(condition)) {
      check(*region, dimension);
    }
  }
}

/// "convection 2" or the name the user gave.
template <class... Kinds>
std::string name_of_law(const std::variant<Kinds...>& condition, std::size_t index) {
  return std::visit(
      [&](const auto& one) {
        return one.name.empty() ? message(one.kind, " ", index + 1) : one.name;
      },
      condition);
}

}  // namespace lapilli
