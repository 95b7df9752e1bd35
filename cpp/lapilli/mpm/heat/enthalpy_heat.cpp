#include "lapilli/mpm/heat/enthalpy_heat.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/mpm/heat/cut_bodies.hpp"
#include "lapilli/mpm/heat/part_sources.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/mpm/heat/weak_exchange.hpp"
#include "lapilli/mpm/transfer/cell_order.hpp"

namespace lapilli {

template <int Dim>
EnthalpyHeat<Dim>::EnthalpyHeat(Points& points, HeatProblem<Dim> problem)
    : points_(points),
      problem_(with_kinks<Dim>(std::move(problem))),
      coefficients_(problem_.bodies, problem_.shape),
      laws_({}),
      part_of_(problem_.bodies.size(), 0),
      number_in_part_(problem_.bodies.size(), 0) {
  CellOrder<Dim>(problem_.grid, support_of(problem_.shape)).update(points_);
  const std::vector<double> start = initial_temperatures(points_, problem_.bodies);
  require_absolute(problem_, points_, start);
  range_ = reached(diverged_beyond(problem_, start));
  for (HeatPart<Dim>& part : make_parts<Dim>(points_, problem_, found_, &contacts_)) {
    for (std::size_t k = 0; k < part.bodies.size(); ++k) {
      part_of_[part.bodies[k]] = solved_.size();
      number_in_part_[part.bodies[k]] = k;
    }
    Solved one;
    const std::size_t size = part.capacity.size();
    one.enthalpy = NodalEnthalpy<Dim>(problem_.bodies, part);
    one.part = std::move(part);
    one.stored.assign(size, 0.0);
    one.heat.assign(size, 0.0);
    one.potential.assign(size, 0.0);
    for (std::size_t place = 0; place < size; ++place) {
      if (one.enthalpy.leads(static_cast<Index>(place))) {
        one.stored[place] =
            one.enthalpy.stored(static_cast<Index>(place), one.part.temperature[place]);
      }
    }
    one.range = NodalRange<Dim>(problem_, one.part);
    one.range.include(one.part.temperature, range_);
    has_sources_ = has_sources_ || !one.part.sources.empty();
    solved_.push_back(std::move(one));
  }
  melts_ = std::any_of(problem_.bodies.begin(), problem_.bodies.end(),
                       [](const HeatBody& body) { return body.material.melts(); });
  // Across a contact the jump of the temperature is drawn towards zero.
  std::vector<HeatBoundary> laws = problem_.settings.boundaries;
  for (const ResistingContact& contact : contacts_) {
    laws.push_back(Convection{"", problem_.settings.contacts[contact.entry].conductance, 0.0, {}});
  }
  laws_ = SurfaceConditions(std::move(laws), absolute_zero(problem_.settings));
  through_contact_.assign(contacts_.size(), 0.0);
  bound_step();
  connect_surface();
  find_self_heating();
  initial_ = balances().front().stored;
}

template <int Dim>
void EnthalpyHeat<Dim>::bound_step() {
  double fastest = 0.0;
  for (const Solved& one : solved_) {
    fastest = std::max(fastest, fastest_rate(one.part));
  }
  limit_.reason =
      "explicit heat: largest eigenvalue of the nodal operator at the largest conductivity and the "
      "least specific heat";
  if (fastest > 0.0) {
    limit_.hard = 2.0 / fastest;
    limit_.automatic = 0.6 * limit_.hard;
    laws_.take_hold_over(limit_.automatic);
  }
}

template <int Dim>
StepsAhead EnthalpyHeat<Dim>::steps_ahead() const {
  StepsAhead all;
  StepLimit limit = limit_;
  self_heating_.bound(limit);
  all.settled = limit.automatic;
  return all;
}

template <int Dim>
StepLimit EnthalpyHeat<Dim>::step_limit() const {
  StepLimit limit = limit_;
  limit.automatic = laws_.step_since_jump(time_, limit.automatic);
  self_heating_.bound(limit);
  return limit;
}

template <int Dim>
StepReport EnthalpyHeat<Dim>::advance(const Step& step) {
  self_heating_.forget();
  for (Solved& one : solved_) {
    conduct(one, step.size);
    one.part.followers.restrict_to_leaders(one.heat);
    release_sources(one, step);
  }
  self_heating_.require_followed(step.size);
  exchange_with_surroundings(step);
  for (Solved& one : solved_) {
    store(one);
  }
  time_ = step.time + step.size;
  if (step.output_due || step.index % 128 == 0) {
    for (const Solved& one : solved_) {
      require_finite_nodes<Dim>(problem_.grid, *one.part.rows, one.part.temperature);
    }
  }
  return {step.size, 0, 0.0};
}

template <int Dim>
void EnthalpyHeat<Dim>::conduct(Solved& one, double size) const {
  std::fill(one.heat.begin(), one.heat.end(), 0.0);
  double* heat = one.heat.data();
  const auto give = [=](Index place, const auto& product) {
    for (std::size_t k = 0; k < product.size(); ++k) {
      heat[place + k] -= size * product[k];
    }
  };
  const auto& own = one.part.own_conduction;
  for (std::size_t body = 0; body < std::max<std::size_t>(1, own.size()); ++body) {
    one.enthalpy.potentials(body, one.part.temperature, one.potential);
    (own.empty() ? *one.part.conduction : *own[body]).multiply(one.potential.data(), give);
  }
}

template <int Dim>
void EnthalpyHeat<Dim>::release_sources(Solved& one, const Step& step) {
  if (one.part.sources.empty()) {
    return;
  }
  const SourceRates given = source_rates(one.part, problem_.bodies, one.part.temperature, step.time,
                                         step.time + step.size);
  for (std::size_t place = 0; place < one.heat.size(); ++place) {
    if (!one.enthalpy.leads(static_cast<Index>(place))) {
      continue;
    }
    double heat = step.size * given.power[place];
    // What melts keeps its temperature, and the source its strength.
    const double per_joule =
        given.fall.empty() ? 0.0
                           : one.enthalpy.at(static_cast<Index>(place), one.stored[place]).slope;
    if (per_joule > 0.0) {
      const double capacity = 1.0 / per_joule, fall = given.fall[place];
      self_heating_.meet(fall, capacity);
      heat =
          capacity * rise_by_source(one.heat[place] * per_joule, heat, step.size * fall, capacity);
    }
    one.heat[place] += heat;
    source_ += heat;
  }
}

template <int Dim>
void EnthalpyHeat<Dim>::find_self_heating() {
  for (const Solved& one : solved_) {
    const SourceRates given =
        source_rates(one.part, problem_.bodies, one.part.temperature, 0.0, 0.0);
    for (std::size_t place = 0; place < given.fall.size(); ++place) {
      if (one.enthalpy.leads(static_cast<Index>(place))) {
        const double per_joule =
            one.enthalpy.at(static_cast<Index>(place), one.stored[place]).slope;
        self_heating_.meet(given.fall[place] * per_joule, 1.0);
      }
    }
  }
}

template <int Dim>
void EnthalpyHeat<Dim>::store(Solved& one) const {
  parallel_for(static_cast<Index>(one.stored.size()), [&](Index place) {
    if (one.enthalpy.leads(place)) {
      one.stored[place] += one.heat[place];
      one.part.temperature[place] = one.enthalpy.at(place, one.stored[place]).temperature;
    }
  });
  // What strays below or above is brought to the bound as a solid where that is a melting point.
  one.range.restore(one.part, range_, one.part.temperature,
                    {[&](Index place, double wanted) {
                       return one.enthalpy.stored(place, wanted) - one.stored[place];
                     },
                     [&](Index place, double heat) {
                       one.stored[place] += heat;
                       one.part.temperature[place] =
                           one.enthalpy.at(place, one.stored[place]).temperature;
                     }});
  one.part.followers.prolong(one.part.temperature);
}

template class EnthalpyHeat<1>;
template class EnthalpyHeat<2>;
template class EnthalpyHeat<3>;

}  // namespace lapilli
