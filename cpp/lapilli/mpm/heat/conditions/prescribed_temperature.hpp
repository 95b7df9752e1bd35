#pragma once

#include <limits>
#include <optional>
#include <string>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/heat/conditions/exchange.hpp"

namespace lapilli {

/// A temperature held on a surface that need not fit the grid.
struct PrescribedTemperature {
  static constexpr const char* kind = "temperature";
  static constexpr const char* modelled = "prescribed temperature";
  static constexpr bool holds_temperature = true, needs_absolute = false;
  std::string name;
  Value value;  // K
  std::optional<Shape> region;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("name of the region in balance and messages"), self.name);
    visit(Key("value").unit("K").required().text("temperature of the surface"), self.value);
    visit(Key("region").text("shape that selects the surface"), self.region);
  }

  const Value* surroundings() const { return &value; }
  const Value* given_coefficient() const { return nullptr; }
  bool is_linear() const { return true; }
  double largest_coefficient(double /*hottest*/, double /*zero*/) const {
    return std::numeric_limits<double>::infinity();
  }
  /// Through what holds it, which the solver gives with the sites.
  void find_exchange(const ExchangeSites& sites, const Exchange& exchange) const;
};

}  // namespace lapilli
