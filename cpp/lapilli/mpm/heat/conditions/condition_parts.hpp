#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <type_traits>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/heat/conditions/exchange.hpp"

namespace lapilli {

// What makes a struct a boundary condition of heat, part by part. Solvers ask heat_boundary.hpp and
// never for a type; a struct in its list that lacks a part does not compile, and the error names
// the part.

/// Its name in scene files, and what `check` says of a scene that has it.
template <class T>
concept HasConditionNames = requires {
  { T::kind } -> std::convertible_to<const char*>;
  { T::modelled } -> std::convertible_to<const char*>;
};

/// Its settings, described (core/describe.hpp), among them the values it is made of.
template <class T>
concept HasConditionSettings = requires(T& condition, void (*visit)(const char*)) {
  &T::template describe<T, decltype(visit)>;
};

/// What users call it, and the part of the surface that it takes.
template <class T>
concept HasConditionRegion = requires(T& condition) {
  { condition.name } -> std::same_as<std::string&>;
  { condition.region } -> std::same_as<std::optional<Shape>&>;
};

/// Whether the surface takes its temperature, behind a layer that the solver chooses.
template <class T>
concept SaysWhetherItHolds = requires {
  { T::holds_temperature } -> std::convertible_to<bool>;
};

/// Whether the temperatures of the scene must be absolute.
template <class T>
concept SaysWhetherAbsolute = requires {
  { T::needs_absolute } -> std::convertible_to<bool>;
};

/// surroundings(): the temperature it would bring the surface to, one of its values; null where
/// there is none.
template <class T>
concept HasSurroundings = requires(const T& condition) {
  { condition.surroundings() } -> std::same_as<const Value*>;
};

/// given_coefficient(): its coefficient of exchange where that is one of its values, else null.
/// largest_coefficient(hottest, zero): a bound on it, W/(m^2 K), on bodies that are nowhere hotter
/// than `hottest` (K above absolute zero, which is at `zero`).
template <class T>
concept HasCoefficient = requires(const T& condition) {
  { condition.given_coefficient() } -> std::same_as<const Value*>;
  { condition.largest_coefficient(0.0, 0.0) } -> std::same_as<double>;
};

/// is_linear(): whether its rate is linear in the temperature.
template <class T>
concept SaysWhetherLinear = requires(const T& condition) {
  { condition.is_linear() } -> std::same_as<bool>;
};

/// find_exchange(sites, exchange): fills all that `exchange` has room for.
template <class T>
concept HasExchange = requires(const T& condition, const ExchangeSites& sites,
                               const Exchange& exchange) {
  condition.find_exchange(sites, exchange);
};

/// True, or a compile error that names the part which is not there.
template <class T>
constexpr bool is_whole_condition() {
  static_assert(HasConditionNames<T>,
                "a boundary condition needs `static constexpr const char* kind` and `modelled`");
  static_assert(HasConditionSettings<T>,
                "a boundary condition needs `describe(self, visit)` for its settings");
  static_assert(HasConditionRegion<T>,
                "a boundary condition needs `std::string name` and `std::optional<Shape> region`");
  static_assert(SaysWhetherItHolds<T>,
                "a boundary condition needs `static constexpr bool holds_temperature`");
  static_assert(SaysWhetherAbsolute<T>,
                "a boundary condition needs `static constexpr bool needs_absolute`");
  static_assert(HasSurroundings<T>,
                "a boundary condition needs `const Value* surroundings() const`");
  static_assert(HasCoefficient<T>,
                "a boundary condition needs `const Value* given_coefficient() const` and "
                "`double largest_coefficient(double hottest, double zero) const`");
  static_assert(SaysWhetherLinear<T>, "a boundary condition needs `bool is_linear() const`");
  static_assert(HasExchange<T>,
                "a boundary condition needs `find_exchange(sites, exchange) const`");
  return true;
}

/// Call use(key, value) for every value among the settings of a condition.
template <class Condition, class Use>
void for_each_value(Condition& condition, const Use& use) {
  auto visit = [&](const Key& key, auto& member) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, Value>) {
      use(key, member);
    }
  };
  std::remove_const_t<Condition>::describe(condition, visit);
}

}  // namespace lapilli
