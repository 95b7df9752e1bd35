#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "lapilli/mpm/heat/conditions/convection.hpp"
#include "lapilli/mpm/heat/conditions/flux.hpp"
#include "lapilli/mpm/heat/conditions/prescribed_temperature.hpp"
#include "lapilli/mpm/heat/conditions/radiation.hpp"
#include "lapilli/mpm/surface/surface_conditions.hpp"

namespace lapilli {

/// The boundary conditions of heat: the one list of them. What makes one stands in
/// condition_parts.hpp; what is asked of any of them, below.
using HeatBoundary = std::variant<Flux, Convection, Radiation, PrescribedTemperature>;

/// Throws std::invalid_argument that says why a condition selects no surface, unless it does.
void require_surface(const std::vector<HeatBoundary>& conditions, std::size_t index, bool is_there);
/// What `check` says of these: each kind once, in the order of the list.
std::vector<const char*> modelled_by(std::span<const HeatBoundary> conditions);

/// The values a condition is made of.
std::vector<const Value*> values_of(const HeatBoundary& condition);
std::vector<Value*> values_of(HeatBoundary& condition);
bool has_function(const HeatBoundary& condition);

/// The temperature it would bring the surface to, null for a flux.
const Value* surroundings_of(const HeatBoundary& condition);
/// The key of the surroundings in scene files; empty for a flux.
std::string key_of_surroundings(const HeatBoundary& condition);
bool holds_temperature(const HeatBoundary& condition);
/// Whether the surface gives heat to surroundings, or takes it from them, that do not hold it.
bool exchanges(const HeatBoundary& condition);
bool needs_absolute(const HeatBoundary& condition);
bool any_needs_absolute(std::span<const HeatBoundary> conditions);

/// Whether rates are linear in the temperature.
bool is_linear(const HeatBoundary& condition);
bool are_linear(std::span<const HeatBoundary> conditions);
/// Whether it is the same all over its surface, whatever the temperature there.
bool is_uniform(const HeatBoundary& condition);
/// Its coefficient of exchange where that is one of its values, else null.
const Value* given_coefficient(const HeatBoundary& condition);
/// A bound on its coefficient of exchange, W/(m^2 K), on bodies that are nowhere hotter than
/// `hottest` (K above absolute zero, which is at `zero`).
double largest_coefficient(const HeatBoundary& condition, double hottest, double zero);

/// Fill `exchange` with what a condition does at its sites; its target where it has surroundings.
void find_exchange(const HeatBoundary& condition, const ExchangeSites& sites,
                   const Exchange& exchange);

}  // namespace lapilli
