#pragma once

#include <optional>
#include <string>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/heat/conditions/exchange.hpp"

namespace lapilli {

/// Newton's law of cooling: flux into the body = coefficient (ambient - T).
struct Convection {
  static constexpr const char* kind = "convection";
  static constexpr const char* modelled = "convection";
  static constexpr bool holds_temperature = false, needs_absolute = false;
  std::string name;
  Value coefficient;  // W/(m^2 K)
  Value ambient;      // K
  std::optional<Shape> region;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name of the region in balance and messages"), self.name);
    visit(Key("coefficient")
              .unit("W/(m^2 K)")
              .non_negative()
              .required()
              .text("heat transfer coefficient"),
          self.coefficient);
    visit(Key("ambient").unit("K").required().text("temperature far away"), self.ambient);
    visit(Key("region").text("shape that selects the surface"), self.region);
  }

  const Value* surroundings() const { return &ambient; }
  const Value* given_coefficient() const { return &coefficient; }
  bool is_linear() const { return !coefficient.is_function(); }
  double largest_coefficient(double /*hottest*/, double /*zero*/) const {
    return coefficient.largest();
  }
  void find_exchange(const ExchangeSites& sites, const Exchange& exchange) const {
    fill_weighted(coefficient, sites, exchange.coefficient);
    fill_ambient(coefficient, ambient, 1, sites, exchange.target);
    finish_linear(exchange);
  }
};

}  // namespace lapilli
