#include "lapilli/mpm/heat/surface_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/mpm/heat/ambient_over_step.hpp"
#include "lapilli/mpm/heat/boundary_conditions.hpp"

namespace lapilli {
namespace {

/// The values a law is made of.
std::vector<const Value*> values_of(const HeatBoundary& law) {
  if (const auto* flux = std::get_if<Flux>(&law)) {
    return {&flux->value};
  }
  if (const auto* convection = std::get_if<Convection>(&law)) {
    return {&convection->coefficient, &convection->ambient};
  }
  if (const auto* radiation = std::get_if<Radiation>(&law)) {
    return {&radiation->emissivity, &radiation->ambient};
  }
  return {&std::get<PrescribedTemperature>(law).value};
}

bool has_function(const HeatBoundary& law) {
  const auto values = values_of(law);
  return std::any_of(values.begin(), values.end(),
                     [](const Value* value) { return value->is_function(); });
}

/// The last jump of a table up to a time, 0 where there is none.
double jump_before(const Value& value, double time) {
  double last = 0.0;
  for (double jump = value.next_jump(0.0); jump <= time; jump = value.next_jump(jump)) {
    last = jump;
  }
  return last;
}

/// The slope of a function of the temperature, by a difference: a flux that falls with the
/// temperature is taken at the end of the step like convection.
void find_slope(const Value& flux, SurfaceSites& sites, double from, double to) {
  double span = 1.0;
  for (const double state : sites.state) {
    span = std::max(span, std::abs(state));
  }
  const double rise = 1e-6 * span;
  std::vector<double> warmer(sites.state), then(sites.state.size());
  for (double& state : warmer) {
    state += rise;
  }
  flux.evaluate_mean(sites.position, warmer, from, to, then);
  for (std::size_t k = 0; k < then.size(); ++k) {
    sites.slope[k] = std::max(0.0, (sites.rate[k] - then[k]) / rise);
  }
}

void renew_layers(SurfaceSites& sites) {
  for (std::size_t k = 0; k < sites.conductivity.size(); ++k) {
    if (sites.conductivity[k] != nullptr) {
      sites.hold[k] = sites.conductivity[k]->at(sites.state[k]) / sites.depth;
    }
  }
}

/// What of a coefficient is left to the surface.
double seen(double coefficient, double hold, bool behind) {
  if (!(hold > 0.0)) {
    return coefficient;
  }
  return behind ? coefficient / (1.0 + coefficient / hold) : std::min(coefficient, hold);
}

}  // namespace

bool passes_layer(const HeatBoundary& law, double hold) {
  constexpr double near = 0.1;
  const auto* convection = std::get_if<Convection>(&law);
  return std::holds_alternative<PrescribedTemperature>(law) ||
         std::holds_alternative<Radiation>(law) ||
         (convection != nullptr && convection->coefficient.largest() > near * hold);
}

SurfaceConditions::SurfaceConditions(std::vector<HeatBoundary> laws, double zero)
    : laws_(std::move(laws)), account_(laws_.size()), zero_(zero) {}

double SurfaceConditions::hold_over(std::size_t law, const HoldLayer& layer, double from,
                                    double to) const {
  const double first = 7.0 * layer.thickness;
  if (!(hold_span_ > 0.0)) {
    return 1.0;
  }
  double since = 0.0;
  for (const Value* value : values_of(laws_[law])) {
    since = std::max(since, jump_before(*value, from));
  }
  const double spans = std::floor((0.5 * (from + to) - since) / hold_span_);
  return std::min(1.0, first * std::exp2(std::min(spans, 60.0)));
}

double SurfaceConditions::last_jump(double time) const {
  double last = 0.0;
  for (const HeatBoundary& law : laws_) {
    for (const Value* value : values_of(law)) {
      last = std::max(last, jump_before(*value, time));
    }
  }
  return last;
}

double SurfaceConditions::step_since_jump(double time, double largest) const {
  constexpr double smallest = 1.0 / 16.0, growth = 0.25;
  if (empty() || !std::isfinite(largest)) {
    return largest;
  }
  const double share = std::clamp(growth * (time - last_jump(time)) / largest, smallest, 1.0);
  return largest * std::exp2(std::round(std::log2(share)));
}

double SurfaceConditions::next_entry(double time) const {
  double next = std::numeric_limits<double>::infinity();
  for (const HeatBoundary& law : laws_) {
    for (const Value* value : values_of(law)) {
      next = std::min(next, value->next_entry(time));
    }
  }
  return next;
}

bool SurfaceConditions::holds_temperature(std::size_t law) const {
  return std::holds_alternative<PrescribedTemperature>(laws_[law]);
}

bool SurfaceConditions::is_uniform(std::size_t law) const {
  return !std::holds_alternative<Radiation>(laws_[law]) && !has_function(laws_[law]);
}

bool SurfaceConditions::is_linear() const {
  return std::none_of(laws_.begin(), laws_.end(), [](const HeatBoundary& law) {
    const auto* flux = std::get_if<Flux>(&law);
    const auto* convection = std::get_if<Convection>(&law);
    return std::holds_alternative<Radiation>(law) ||
           (flux != nullptr && flux->value.is_function()) ||
           (convection != nullptr && convection->coefficient.is_function());
  });
}

bool SurfaceConditions::jumps_within(double from, double to) const {
  const double before = std::nextafter(from, -std::numeric_limits<double>::infinity());
  return std::any_of(laws_.begin(), laws_.end(), [&](const HeatBoundary& law) {
    const auto values = values_of(law);
    return std::any_of(values.begin(), values.end(),
                       [&](const Value* value) { return value->next_jump(before) < to; });
  });
}

UniformLaw SurfaceConditions::uniform(std::size_t law, double hold, const HoldLayer& layer,
                                      double from, double to) const {
  UniformLaw made;
  if (const auto* flux = std::get_if<Flux>(&laws_[law])) {
    made.flux = flux->value.mean(from, to);
  } else if (const auto* convection = std::get_if<Convection>(&laws_[law])) {
    made.coefficient = seen(convection->coefficient.mean(from, to), hold, layer.behind);
    made.ambient = ambient_over(convection->coefficient, convection->ambient, 1, zero_, from, to);
  } else {
    made.coefficient = hold;
    made.ambient = std::get<PrescribedTemperature>(laws_[law]).value.mean(from, to);
  }
  if (const double share = hold_over(law, layer, from, to); share < 1.0 && hold > 0.0) {
    made.coefficient = std::min(made.coefficient, share * hold);
  }
  return made;
}

void SurfaceConditions::evaluate(std::size_t law, SurfaceSites& sites, double from,
                                 double to) const {
  renew_layers(sites);
  const std::size_t count = sites.area.size();
  std::vector<double> first(count), second(count);
  const auto fill = [&](const Value& value, std::vector<double>& to_fill) {
    value.evaluate_mean(sites.position, sites.state, from, to, to_fill);
  };
  const auto fill_ambient = [&](const Value& coefficient, const Value& ambient, int power) {
    if (ambient.is_function()) {
      fill(ambient, second);
    } else {
      std::fill(second.begin(), second.end(),
                ambient_over(coefficient, ambient, power, zero_, from, to));
    }
  };
  if (const auto* flux = std::get_if<Flux>(&laws_[law])) {
    fill(flux->value, sites.rate);
    std::fill(sites.slope.begin(), sites.slope.end(), 0.0);
    if (flux->value.is_function()) {
      find_slope(flux->value, sites, from, to);
    }
    return;
  }
  if (const auto* convection = std::get_if<Convection>(&laws_[law])) {
    fill(convection->coefficient, sites.slope);
    fill_ambient(convection->coefficient, convection->ambient, 1);
  } else if (const auto* radiation = std::get_if<Radiation>(&laws_[law])) {
    fill(radiation->emissivity, first);
    fill_ambient(radiation->emissivity, radiation->ambient, 4);
    for (std::size_t k = 0; k < count; ++k) {
      const double own = std::max(sites.state[k] - zero_, 0.0), far = second[k] - zero_;
      sites.slope[k] =
          first[k] * radiation->stefan_boltzmann * (far * far + own * own) * (far + own);
    }
  } else {
    sites.slope = sites.hold;
    fill(std::get<PrescribedTemperature>(laws_[law]).value, second);
  }
  const double share = hold_over(law, sites.layer, from, to);
  const bool exchanges = !holds_temperature(law) && !sites.hold.empty();
  for (std::size_t k = 0; k < count; ++k) {
    if (exchanges) {
      sites.slope[k] = seen(sites.slope[k], sites.hold[k], sites.layer.behind);
    }
    if (share < 1.0 && sites.hold[k] > 0.0) {
      sites.slope[k] = std::min(sites.slope[k], share * sites.hold[k]);
    }
    sites.rate[k] = sites.slope[k] * (second[k] - sites.state[k]);
  }
}

}  // namespace lapilli
