#pragma once

#include <utility>

#include "lapilli/core/describe.hpp"
#include "lapilli/peridynamics/influence.hpp"

namespace lapilli {

/// How second derivatives are formed.
enum class Laplacian {
  literal,      // the paper's: gradient, then divergence (two fields); leaves saw teeth undamped
  zero_energy,  // literal, and the part of a bond difference that the gradients do not explain
  compact,      // bond differences with the constant of a full lattice
  corrected     // bond differences that keep linear fields, at walls and open sides too
};

template <>
struct Names<Laplacian> {
  static constexpr std::pair<Laplacian, const char*> values[] = {
      {Laplacian::literal, "literal"},
      {Laplacian::zero_energy, "zero-energy"},
      {Laplacian::compact, "compact"},
      {Laplacian::corrected, "corrected"}};
};

/// Heat conduction on the thermal horizon.
struct PeridynamicHeatSettings {
  double horizon = 0.0;  // in spacings; 0: see widest_horizon and ConductionAtRest
  Influence influence = Influence::gaussian;
  Laplacian laplacian = Laplacian::corrected;
  double zero_energy = 0.5;          // coefficient of the zero-energy term
  bool viscous_dissipation = false;  // viscous heating
  double skin = 0.3;                 // in spacings; families are searched again after half of it
  double step_factor = 0.25;         // of spacing^2 / (dimension diffusivity)

  /// In spacings: the horizon that is given, otherwise the longest that is chosen.
  double widest_horizon() const { return horizon > 0.0 ? horizon : 1.515; }

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("horizon").range(0.0, 10.0).text(
              "thermal horizon, in spacings, above 1; 0: 1.2 for points at rest on a lattice "
              "that their surface follows, 2.015 for points that flow, otherwise 1.515"),
          self.horizon);
    visit(Key("influence").text("weight of a bond by its length"), self.influence);
    visit(Key("laplacian").text("how conduction is formed from bonds"), self.laplacian);
    visit(Key("zero_energy").non_negative().text("coefficient of the zero-energy term"),
          self.zero_energy);
    visit(Key("viscous_dissipation").text("whether viscous work becomes heat"),
          self.viscous_dissipation);
    visit(Key("skin")
              .range(0.0, 2.0, true)
              .text("reach of the neighbour list beyond the horizon, in "
                    "spacings"),
          self.skin);
    visit(Key("step_factor").range(0.0, 1.0, true).text("of spacing^2 / (dimension diffusivity)"),
          self.step_factor);
  }
};

/// The settings with the horizon that points which flow need where none is given. Their bonds are
/// as irregular as packing makes them: with the eight next neighbours the conductivity of the whole
/// comes out 1.5 % low, with twenty right, for a tenth of the time of a step.
inline PeridynamicHeatSettings for_flow(PeridynamicHeatSettings settings) {
  if (settings.horizon == 0.0 && settings.laplacian == Laplacian::corrected) {
    settings.horizon = 2.015;
  }
  return settings;
}

}  // namespace lapilli
