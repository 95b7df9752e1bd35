#pragma once

#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"

namespace lapilli {

/// Thermal contact resistance where two bodies touch: the flux is conductance (T_a - T_b). Without
/// an entry bodies that touch have one temperature there.
struct HeatContact {
  std::vector<std::string> bodies;  // two names; empty: every pair that no other entry names
  Value conductance;                // W/(m^2 K)

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("bodies").length(0, 2).text(
              "names of the two bodies; empty: every pair that no other entry names"),
          self.bodies);
    visit(Key("conductance")
              .unit("W/(m^2 K)")
              .non_negative()
              .required()
              .text("thermal contact conductance: flux over the jump of the temperature"),
          self.conductance);
  }
};

}  // namespace lapilli
