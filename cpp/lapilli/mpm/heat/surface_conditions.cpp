#include "lapilli/mpm/heat/surface_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lapilli {
namespace {

void renew_layers(SurfaceSites& sites) {
  for (std::size_t k = 0; k < sites.conductivity.size(); ++k) {
    if (sites.conductivity[k] != nullptr) {
      sites.hold[k] = sites.conductivity[k]->at(sites.state[k]) / sites.depth;
    }
  }
}

/// How a condition passes the layer of its sites.
struct Passage {
  bool holds, behind;
  double share;  // of what the layer lets through, up to 1

  /// What a layer of the coefficient `hold` leaves of a coefficient to the surface.
  double left(double coefficient, double hold) const {
    if (!(hold > 0.0)) {
      return coefficient;
    }
    const double seen = holds    ? coefficient
                        : behind ? coefficient / (1.0 + coefficient / hold)
                                 : std::min(coefficient, hold);
    return share < 1.0 ? std::min(seen, share * hold) : seen;
  }
};

}  // namespace

bool passes_layer(const HeatBoundary& law, double hold) {
  constexpr double near = 0.1, unknown = std::numeric_limits<double>::infinity();
  // No number is an emissivity of zero times no bound.
  return holds_temperature(law) || !(largest_coefficient(law, unknown, 0.0) <= near * hold);
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
    since = std::max(since, value->last_jump(from));
  }
  const double spans = std::floor((0.5 * (from + to) - since) / hold_span_);
  return std::min(1.0, first * std::exp2(std::min(spans, 60.0)));
}

double SurfaceConditions::last_jump(double time) const {
  double last = 0.0;
  for (const HeatBoundary& law : laws_) {
    for (const Value* value : values_of(law)) {
      last = std::max(last, value->last_jump(time));
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

double SurfaceConditions::last_entry(double time) const {
  double last = -std::numeric_limits<double>::infinity();
  for (const HeatBoundary& law : laws_) {
    for (const Value* value : values_of(law)) {
      last = std::max(last, value->last_entry(time));
    }
  }
  return last;
}

bool SurfaceConditions::jumps_within(double from, double to) const {
  const double before = std::nextafter(from, -std::numeric_limits<double>::infinity());
  return std::ranges::any_of(laws_, [&](const HeatBoundary& law) {
    return std::ranges::any_of(values_of(law),
                               [&](const Value* value) { return value->next_jump(before) < to; });
  });
}

UniformLaw SurfaceConditions::uniform(std::size_t law, double hold, const HoldLayer& layer,
                                      double from, double to) const {
  UniformLaw made;
  const Vec3 anywhere = Vec3::Zero();
  const double any_state = 0.0;
  find_exchange(laws_[law], {{&anywhere, 1}, {&any_state, 1}, {&hold, 1}, {}, from, to, zero_},
                {{&made.flux, 1}, {&made.coefficient, 1}, {&made.ambient, 1}, {}});
  const Passage passage{holds_temperature(law), layer.behind, hold_over(law, layer, from, to)};
  made.coefficient = passage.left(made.coefficient, hold);
  return made;
}

void SurfaceConditions::evaluate(std::size_t law, SurfaceSites& sites, double from,
                                 double to) const {
  renew_layers(sites);
  std::vector<double> target(sites.area.size());
  const Exchange exchange{sites.rate, sites.slope, target, {}};
  find_exchange(laws_[law], {sites.position, sites.state, sites.hold, {}, from, to, zero_},
                exchange);
  if (surroundings_of(laws_[law]) == nullptr) {
    return;  // the flux is the rate
  }
  if (!sites.hold.empty()) {
    const Passage passage{holds_temperature(law), sites.layer.behind,
                          hold_over(law, sites.layer, from, to)};
    for (std::size_t k = 0; k < sites.slope.size(); ++k) {
      sites.slope[k] = passage.left(sites.slope[k], sites.hold[k]);
    }
  }
  add_exchange(exchange, sites.state);
}

}  // namespace lapilli
