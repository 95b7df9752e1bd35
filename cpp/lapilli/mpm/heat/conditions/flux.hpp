#pragma once

#include <optional>
#include <string>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/heat/conditions/exchange.hpp"

namespace lapilli {

/// A prescribed flux into the body.
struct Flux {
  static constexpr const char* kind = "flux";
  static constexpr const char* modelled = "prescribed flux";
  static constexpr bool holds_temperature = false, needs_absolute = false;
  std::string name;
  Value value;                  // W/m^2, positive into the body
  std::optional<Shape> region;  // the surface inside this shape; all that is left when absent

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name of the region in balance and messages"), self.name);
    visit(Key("value").unit("W/m^2").required().text("flux, positive into the body"), self.value);
    visit(Key("region").text("shape that selects the surface"), self.region);
  }

  const Value* surroundings() const { return nullptr; }
  const Value* given_coefficient() const { return nullptr; }
  bool is_linear() const { return !value.is_function(); }
  double largest_coefficient(double /*hottest*/, double /*zero*/) const { return 0.0; }
  void find_exchange(const ExchangeSites& sites, const Exchange& exchange) const {
    find_flux(value, sites, exchange);
  }
};

}  // namespace lapilli
