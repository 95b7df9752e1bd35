#pragma once

#include "lapilli/core/describe.hpp"
#include "lapilli/materials/symmetric_tensor.hpp"

namespace lapilli {

/// A solid that stores and conducts heat (Fourier), with constant coefficients.
/// Not modelled: temperature dependence, phase change.
struct Thermal {
  static constexpr const char* kind = "thermal";
  double density = 0.0;          // kg/m^3, of the undeformed body
  double specific_heat = 0.0;    // J/(kg K)
  SymmetricTensor conductivity;  // W/(m K); a number is isotropic

  bool operator==(const Thermal&) const = default;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("density").unit("kg/m^3").positive().required().text("mass per undeformed volume"),
          self.density);
    visit(Key("specific_heat")
              .unit("J/(kg K)")
              .positive()
              .required()
              .text("heat per mass and kelvin"),
          self.specific_heat);
    visit(
        Key("conductivity")
            .unit("W/(m K)")
            .required()
            .text(
                "thermal conductivity: a number, or xx, yy, zz, xy, yz, xz of a symmetric tensor"),
        self.conductivity);
  }

  /// Heat capacity of an undeformed volume, J/(m3 K).
  double capacity() const { return density * specific_heat; }
};

/// Throws std::invalid_argument unless density and specific heat are positive and finite and the
/// conductivity is finite and positive semi-definite (zero insulates).
void check(const Thermal& material);

/// Largest eigenvalue of the conductivity, which limits an explicit step, W/(m K).
double largest_conductivity(const Thermal& material);

}  // namespace lapilli
