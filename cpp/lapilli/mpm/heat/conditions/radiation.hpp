#pragma once

#include <optional>
#include <string>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/heat/conditions/exchange.hpp"

namespace lapilli {

/// Grey-body exchange: flux into the body = emissivity sigma (ambient^4 - T^4), of absolute
/// temperatures.
struct Radiation {
  static constexpr const char* kind = "radiation";
  static constexpr const char* modelled = "radiation";
  static constexpr bool holds_temperature = false, needs_absolute = true;
  std::string name;
  Value emissivity = 1.0;                    // 0 to 1
  Value ambient;                             // K, or degrees Celsius where the scene says so
  double stefan_boltzmann = 5.670374419e-8;  // W/(m^2 K^4), in the scene's units
  std::optional<Shape> region;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name of the region in balance and messages"), self.name);
    visit(Key("emissivity").range(0.0, 1.0).text("emissivity"), self.emissivity);
    visit(Key("ambient").unit("K").required().text(
              "temperature far away, absolute unless temperature_unit says otherwise"),
          self.ambient);
    visit(Key("stefan_boltzmann")
              .unit("W/(m^2 K^4)")
              .positive()
              .text("Stefan-Boltzmann constant in the scene's units"),
          self.stefan_boltzmann);
    visit(Key("region").text("shape that selects the surface"), self.region);
  }

  const Value* surroundings() const { return &ambient; }
  const Value* given_coefficient() const { return nullptr; }
  bool is_linear() const { return false; }
  double largest_coefficient(double hottest, double zero) const;
  /// The secant to the ambient is sigma e (Ta^2 + T^2)(Ta + T): at a cold start the tangent
  /// 4 sigma e T^3 restores nothing, and a step would pass the ambient.
  void find_exchange(const ExchangeSites& sites, const Exchange& exchange) const;
};

}  // namespace lapilli
