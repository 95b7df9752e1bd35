#pragma once

#include <optional>

#include "lapilli/core/describe.hpp"
#include "lapilli/materials/over_temperature.hpp"
#include "lapilli/materials/symmetric_tensor.hpp"

namespace lapilli {

/// A solid that stores and conducts heat (Fourier); specific heat and an isotropic conductivity may
/// depend on the temperature, and it may melt. Not modelled: a change of density, undercooling.
struct Thermal {
  static constexpr const char* kind = "thermal";
  double density = 0.0;                           // kg/m^3, of the undeformed body
  OverTemperature<double> specific_heat;          // J/(kg K)
  OverTemperature<SymmetricTensor> conductivity;  // W/(m K); a number is isotropic
  double latent_heat = 0.0;                       // J/kg
  std::optional<double> solidus{}, liquidus{};    // K; one alone stands for both

  bool operator==(const Thermal&) const = default;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("density").unit("kg/m^3").positive().required().text("mass per undeformed volume"),
          self.density);
    visit(Key("specific_heat")
              .unit("J/(kg K)")
              .positive()
              .required()
              .text("heat per mass and kelvin: a number, or a table over the temperature"),
          self.specific_heat);
    visit(Key("conductivity")
              .unit("W/(m K)")
              .required()
              .text("thermal conductivity: a number, xx, yy, zz, xy, yz, xz of a symmetric "
                    "tensor, or a table over the temperature"),
          self.conductivity);
    visit(Key("latent_heat").unit("J/kg").non_negative().text("heat of melting per mass"),
          self.latent_heat);
    visit(Key("solidus").unit("K").text("temperature at which melting begins"), self.solidus);
    visit(Key("liquidus").unit("K").text("temperature at which melting ends, solidus unless said"),
          self.liquidus);
  }

  /// Heat capacity of an undeformed volume, J/(m3 K): the least there is.
  double capacity() const { return density * specific_heat.least(); }
  bool melts() const { return latent_heat > 0.0; }
  /// Whether stored or conducted heat is not linear in the temperature.
  bool varies() const { return specific_heat.varies() || conductivity.varies() || melts(); }
  double melting_begins() const { return solidus ? *solidus : liquidus.value_or(0.0); }
  double melting_ends() const { return liquidus ? *liquidus : solidus.value_or(0.0); }
};

/// Throws std::invalid_argument unless density and specific heat are positive and finite, the
/// conductivity is finite and positive semi-definite (zero insulates), and what melts says where.
void check(const Thermal& material);

/// Largest eigenvalue of the conductivity, which limits an explicit step, W/(m K).
double largest_conductivity(const Thermal& material);

/// How far heat comes into a material within a time (s), m: the root of diffusivity x time.
double depth_of_heat(const Thermal& material, double time);

}  // namespace lapilli
