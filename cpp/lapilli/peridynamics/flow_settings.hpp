#pragma once

#include <utility>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/peridynamics/heat_settings.hpp"
#include "lapilli/peridynamics/influence.hpp"

namespace lapilli {

/// How temperature drives the flow.
enum class Buoyancy {
  reduced,  // b = -rho0 beta (T - T_ref) g: only the part of gravity that moves anything
  full      // rho0 (1 - beta (T - T_ref)) g, the paper's: the same flow, and pressure of all weight
};

template <>
struct Names<Buoyancy> {
  static constexpr std::pair<Buoyancy, const char*> values[] = {{Buoyancy::reduced, "reduced"},
                                                                {Buoyancy::full, "full"}};
};

/// Weakly compressible viscous flow on the fluid horizon.
struct PeridynamicFlowSettings {
  std::vector<double> gravity;  // m/s^2; empty: none

  /// A uniform weight and the pressure rho0 g . x that bears it cancel wherever points are. Neither
  /// enters the sums over bonds: their error would be 1/(beta dT) times the buoyancy.
  Buoyancy buoyancy = Buoyancy::reduced;

  double horizon = 3.015;  // in spacings
  Influence influence = Influence::gaussian;
  Laplacian laplacian = Laplacian::corrected;  // of the viscous force
  double zero_energy = 1.0;                    // coefficient of the zero-energy term

  double sound_speed = 0.0;  // m/s; 0: max(factor sqrt(g beta dT l), 10 wall speed, 10 nu / l)
  double sound_speed_factor = 5.0;         // of sqrt(g beta dT l)
  double length = 0.0;                     // m, l; 0: extent of the fluid along gravity
  double temperature_range = 0.0;          // K, dT; 0: what walls and the start span
  double stiffness_exponent = 7.0;         // of the equation of state
  double density_diffusion = 0.1;          // smooths the pressure; 0: none, as in the paper
  double shifting = 0.1;                   // keeps points evenly spread, away from neighbours
  double courant = 0.5;                    // of spacing / sound speed
  double viscous_step = 0.25;              // of spacing^2 / (dimension nu)
  double skin = 0.3;                       // in spacings
  double largest_density_variation = 0.1;  // a run beyond it stops

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("gravity").unit("m/s^2").length(0, 3).text("empty: none"), self.gravity);
    visit(Key("buoyancy")
              .text("reduced: only what temperature changes; full: the pressure bears all of the "
                    "weight"),
          self.buoyancy);
    visit(Key("horizon").range(1.0, 10.0, true).text("fluid horizon, in spacings"), self.horizon);
    visit(Key("influence").text("weight of a bond by its length"), self.influence);
    visit(Key("laplacian").text("how the viscous force is formed from bonds"), self.laplacian);
    visit(Key("zero_energy").non_negative().text("coefficient of the zero-energy term"),
          self.zero_energy);
    visit(Key("sound_speed")
              .unit("m/s")
              .non_negative()
              .text("0: max(factor sqrt(g beta dT l), 10 wall speed, 10 nu / l)"),
          self.sound_speed);
    visit(Key("sound_speed_factor").positive().text("of sqrt(g beta dT l)"),
          self.sound_speed_factor);
    visit(
        Key("length").unit("m").non_negative().text("l of the sound speed; 0: height of the fluid"),
        self.length);
    visit(Key("temperature_range")
              .unit("K")
              .non_negative()
              .text("dT of the sound speed; 0: what walls, their surroundings and the start span"),
          self.temperature_range);
    visit(Key("stiffness_exponent").positive().text("of the equation of state"),
          self.stiffness_exponent);
    visit(Key("density_diffusion").non_negative().text("smooths the pressure"),
          self.density_diffusion);
    visit(Key("shifting").non_negative().text("keeps points evenly spread"), self.shifting);
    visit(Key("courant").range(0.0, 1.0, true).text("of spacing / sound speed"), self.courant);
    visit(Key("viscous_step").range(0.0, 1.0, true).text("of spacing^2 / (dimension nu)"),
          self.viscous_step);
    visit(Key("skin")
              .range(0.0, 2.0, true)
              .text("reach of the neighbour list beyond the horizon, in "
                    "spacings"),
          self.skin);
    visit(Key("largest_density_variation").range(0.0, 1.0, true).text("a run beyond it stops"),
          self.largest_density_variation);
  }
};

}  // namespace lapilli
