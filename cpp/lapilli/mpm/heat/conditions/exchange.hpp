#pragma once

#include <span>

#include "lapilli/core/value.hpp"

namespace lapilli {

/// Where a boundary condition of heat acts, and over which span of time. Tables count by their
/// means over it, functions at its middle.
struct ExchangeSites {
  std::span<const Vec3> position;  // m
  std::span<const double> state;   // K, of the surface
  std::span<const double> hold;    // W/(m^2 K), through which a temperature is held there
  std::span<const double> weight;  // all results are times it (areas, m^(dim-1)); 1 where empty
  double begin = 0.0, end = 0.0;   // s
  double zero = 0.0;               // absolute zero in the unit of the temperatures
};

/// What a condition does at every site: heat enters at the rate
///     flux + coefficient (target - T)    (W/m^2).
/// The coefficient is the secant to the target, which a step that takes it at its end does not
/// pass. Without surroundings the flux is all of the rate, and the coefficient how much it falls
/// for every kelvin.
struct Exchange {
  std::span<double> flux;         // W/m^2, positive into the body
  std::span<double> coefficient;  // W/(m^2 K), not negative
  std::span<double> target;       // K, of a condition that has surroundings
  std::span<double> tangent;      // W/(m^2 K), -d rate/dT for Newton; empty where nobody asks
};

/// Turn the fluxes into rates: add coefficient (target - T).
void add_exchange(const Exchange& exchange, std::span<const double> state);

// What conditions are written with:

/// Fill with the means of a value, by weight.
void fill_weighted(const Value& value, const ExchangeSites& sites, std::span<double> filled);
/// Fill with the temperature of the surroundings: its mean weighted by the coefficient, of the
/// power-th power above absolute zero (see ambient_over).
void fill_ambient(const Value& coefficient, const Value& ambient, int power,
                  const ExchangeSites& sites, std::span<double> filled);
/// A flux given by a value, with the slope of a function by a difference.
void find_flux(const Value& value, const ExchangeSites& sites, const Exchange& exchange);
/// No flux, and the coefficient for a tangent: of a rate that is linear in the temperature.
void finish_linear(const Exchange& exchange);

}  // namespace lapilli
