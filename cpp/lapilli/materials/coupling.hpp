#pragma once

#include "lapilli/core/describe.hpp"

namespace lapilli {

/// Isotropic expansion with temperature: free strain = coefficient times the change of temperature.
/// Not modelled: dependence on direction or temperature.
struct ThermalExpansion {
  static constexpr const char* kind = "thermal_expansion";
  double coefficient = 0.0;  // 1/K, of length

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("coefficient").unit("1/K").required().text("relative change of length per kelvin"),
          self.coefficient);
  }
};

/// Heat released by plastic work (Taylor and Quinney 1934).
struct PlasticHeating {
  static constexpr const char* kind = "plastic_heating";
  double share = 0.9;  // of the plastic work

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("share").range(0.0, 1.0).text("share of the plastic work that becomes heat"),
          self.share);
  }
};

}  // namespace lapilli
