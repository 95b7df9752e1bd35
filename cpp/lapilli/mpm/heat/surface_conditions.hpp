#pragma once

#include <string>
#include <vector>

#include "lapilli/core/balance.hpp"
#include "lapilli/core/physics.hpp"
#include "lapilli/materials/over_temperature.hpp"
#include "lapilli/mpm/heat/condition_account.hpp"
#include "lapilli/mpm/heat/heat_settings.hpp"

namespace lapilli {

/// Through what a surface is held at a temperature. Conditions on the surface itself, at every site
/// of a cut cell, ask more of its nodes than they can follow: the stiffer, the more they lock (held
/// through 1e-4 cells, a square at 45 degrees with a source is 17 % too cold at 7 cells across).
/// Behind a layer they do not; and with the temperature taken at half its depth, where heat enters
/// too, what the layer resists is what the body lacks there, so that linear fields stay exact.
struct HoldLayer {
  double thickness = 0.02;  // cells
  bool behind = false;      // whether exchange passes it, and temperatures are those in its middle
};

/// Places on the true surface where one law acts, each standing for a piece of it.
struct SurfaceSites {
  std::vector<Vec3> position;  // m
  std::vector<Vec3> normal;    // unit, outward
  std::vector<double> area;    // m^(dim-1)
  std::vector<double> hold;    // W/(m^2 K), of the layer through which a temperature is held there
  HoldLayer layer;
  double depth = 0.0;  // m, of the layer
  // By site, of bodies whose conductivity depends on the temperature; empty where no body has one.
  std::vector<const TemperatureTable*> conductivity;

  // Of the last evaluation, at the temperature of the surface itself:
  std::vector<double> state;  // K
  std::vector<double> rate;   // W/m^2 into the body
  std::vector<double> slope;  // W/(m^2 K), -d rate/dT for the implicit side, not negative
};

/// What a law is where it is the same all over its surface: rate = coefficient (ambient - T) +
/// flux.
struct UniformLaw {
  double coefficient = 0.0;  // W/(m^2 K)
  double ambient = 0.0;      // K
  double flux = 0.0;         // W/m^2
};

/// Whether a law acts through the layer of a coefficient `hold`: a temperature that is held, and
/// exchange that comes near.
bool passes_layer(const HeatBoundary& law, double hold);

/// The boundary conditions of a scene where the surface itself is known, at the surface's own
/// temperature. All that exchange are one, rate = coefficient (ambient - T), with the coefficient
/// that the layer leaves to the surface.
class SurfaceConditions {
 public:
  /// `zero` is absolute zero in the unit of the temperatures.
  explicit SurfaceConditions(std::vector<HeatBoundary> laws, double zero = 0.0);

  /// Let strong laws take hold over the first spans of this length (s) after the start and after
  /// every jump of their tables: a coefficient of 7 conductivity / cell at most, doubled from span
  /// to span. A surface that is held at once throws nodes beside it out of the range.
  void take_hold_over(double span) { hold_span_ = span; }
  /// The last jump of a table up to this time; the start where there is none, s.
  double last_jump(double time) const;
  /// An automatic step at this time, s, at most `largest`. What has just begun goes as the root of
  /// the time: steps grow with the time since, by powers of two, so that factors of the surface
  /// serve many.
  double step_since_jump(double time, double largest) const;
  /// The next time at which a table of any law has an entry, s; infinite where none has.
  double next_entry(double time) const;
  /// The last such time from the start up to this one; minus infinity where there is no table.
  double last_entry(double time) const;

  std::size_t size() const { return laws_.size(); }
  bool empty() const { return laws_.empty(); }
  const HeatBoundary& operator[](std::size_t law) const { return laws_[law]; }
  bool holds_temperature(std::size_t law) const { return lapilli::holds_temperature(laws_[law]); }
  /// Whether the law is the same all over a surface of one material, whatever its temperature.
  bool is_uniform(std::size_t law) const { return lapilli::is_uniform(laws_[law]); }
  /// Whether rates are linear in the temperature.
  bool is_linear() const { return are_linear(laws_); }
  /// Whether a table of any law jumps in [from, to).
  bool jumps_within(double from, double to) const;

  /// A uniform law over a step, whose sites have this `hold` and `layer`.
  UniformLaw uniform(std::size_t law, double hold, const HoldLayer& layer, double from,
                     double to) const;
  /// Rates and slopes of any law over a step at sites.state; there layers of a conductivity that
  /// depends on the temperature are renewed first.
  void evaluate(std::size_t law, SurfaceSites& sites, double from, double to) const;

  ConditionAccount& account() { return account_; }
  const ConditionAccount& account() const { return account_; }
  std::vector<Balance::Entry> entries() const { return account_.entries(laws_); }

 private:
  /// How much of `hold` a law may have, up to 1.
  double hold_over(std::size_t law, const HoldLayer& layer, double from, double to) const;

  std::vector<HeatBoundary> laws_;
  ConditionAccount account_;
  double zero_;
  double hold_span_ = 0.0;  // s
};

}  // namespace lapilli
