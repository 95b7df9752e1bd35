#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/value.hpp"

namespace lapilli {

/// What a wall does to the fluid that touches it.
enum class Slip { no_slip, free_slip };

template <>
struct Names<Slip> {
  static constexpr std::pair<Slip, const char*> values[] = {{Slip::no_slip, "no-slip"},
                                                            {Slip::free_slip, "free-slip"}};
};

/// What a wall does to heat.
enum class WallHeat { adiabatic, temperature, flux, convection };

template <>
struct Names<WallHeat> {
  static constexpr std::pair<WallHeat, const char*> values[] = {
      {WallHeat::adiabatic, "adiabatic"},
      {WallHeat::temperature, "temperature"},
      {WallHeat::flux, "flux"},
      {WallHeat::convection, "convection"}};
};

/// One wall of a peridynamic fluid: a body of wall points of at least one horizon's thickness.
struct FluidWallSettings {
  std::string name = "wall";
  Slip slip = Slip::no_slip;
  std::vector<double> velocity;  // m/s; empty: at rest
  bool moves = false;  // the points travel with `velocity`; otherwise only their surface runs
  WallHeat heat = WallHeat::adiabatic;
  Value temperature = 0.0;   // K; of the surface, or of the surroundings for convection
  Value flux = 0.0;          // W/m^2 into the fluid
  double coefficient = 0.0;  // W/(m^2 K), convection

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("name").text("how output calls the wall"), self.name);
    visit(Key("slip").text("whether the fluid sticks to the wall"), self.slip);
    visit(Key("velocity").unit("m/s").length(0, 3).text("velocity of the wall's surface"),
          self.velocity);
    visit(Key("moves").text("whether the wall's points travel with that velocity"), self.moves);
    visit(Key("heat").text("thermal condition on the wall"), self.heat);
    visit(Key("temperature").unit("K").text("of the surface, or of the surroundings (convection)"),
          self.temperature);
    visit(Key("flux").unit("W/m^2").text("heat flux into the fluid"), self.flux);
    visit(Key("coefficient").unit("W/(m^2 K)").non_negative().text("of convection"),
          self.coefficient);
  }
};

/// Throws std::invalid_argument, naming the wall, for settings that contradict each other or the
/// dimension, and for those that `heat` would leave without effect.
void check(const FluidWallSettings& wall, int dimension);

}  // namespace lapilli
