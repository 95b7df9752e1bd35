#include "lapilli/mpm/heat/cut_cell_heat.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/asks_for_points.hpp"
#include "lapilli/mpm/heat/cut_bodies.hpp"
#include "lapilli/mpm/heat/part_sources.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/mpm/transfer/cell_order.hpp"

namespace lapilli {

template <int Dim>
bool CutCellHeat<Dim>::suits(const HeatProblem<Dim>& problem) {
  const HeatSettings& settings = problem.settings;
  // On a line the points know the surface as well, and without a law that depends on its
  // temperature their capacities err less (rod under a flux, h = 0.1 m: 3.1e-5 against 1.1e-4 K).
  // Points take a joint of two materials where their cells end (off the lattice: 5.5 %).
  const bool better_by_points =
      Dim == 1 && settings.contacts.empty() &&
      std::all_of(
          problem.bodies.begin(), problem.bodies.end(),
          [&](const HeatBody& body) { return body.material == problem.bodies.front().material; }) &&
      std::none_of(problem.bodies.begin(), problem.bodies.end(),
                   [](const HeatBody& body) { return body.material.varies(); }) &&
      std::ranges::all_of(settings.boundaries,
                          [](const HeatBoundary& law) { return surroundings_of(law) == nullptr; });
  return !problem.moving && !better_by_points && !asks_for_points(settings) &&
         std::all_of(problem.bodies.begin(), problem.bodies.end(),
                     [](const HeatBody& body) { return body.shape.has_value(); });
}

template <int Dim>
CutCellHeat<Dim>::CutCellHeat(Points& points, HeatProblem<Dim> problem)
    : points_(points),
      problem_(with_kinks<Dim>(std::move(problem))),
      coefficients_(problem_.bodies, problem_.shape),
      laws_(problem_.settings.boundaries, absolute_zero(problem_.settings)),
      part_of_(problem_.bodies.size(), 0) {
  CellOrder<Dim>(problem_.grid, support_of(problem_.shape)).update(points_);
  const std::vector<double> start = initial_temperatures(points_, problem_.bodies);
  require_absolute(problem_, points_, start);
  range_ = reached(diverged_beyond(problem_, start));
  for (HeatPart<Dim>& part : make_parts<Dim>(points_, problem_, found_)) {
    for (const std::size_t body : part.bodies) {
      part_of_[body] = solved_.size();
    }
    Solved one;
    one.inverse.assign(part.capacity.size(), 0.0);
    for (std::size_t place = 0; place < part.capacity.size(); ++place) {
      if (part.capacity[place] > 0.0) {
        one.inverse[place] = 1.0 / part.capacity[place];
      } else if (part.followers.follows(static_cast<Index>(place))) {
        one.inverse[place] = 1.0;
      }
    }
    one.increment.assign(part.capacity.size(), 0.0);
    one.near.unknown_place = part.unknown_place;
    one.part = std::move(part);
    if (is_implicit()) {
      number_all_leaders(one);
    }
    solved_.push_back(std::move(one));
  }
  std::vector<double> rates;
  for (Solved& one : solved_) {
    rates.push_back(fastest_rate(one.part));
    one.range = NodalRange<Dim>(problem_, one.part);
    one.range.include(one.part.temperature, range_);
  }
  connect_surface(rates);
  bound_step(rates);
  find_self_heating(0.0);
  if (is_adaptive()) {
    begin_adaptive_steps();
  }
  initial_ = balances().front().stored;
}

template <int Dim>
void CutCellHeat<Dim>::bound_step(const std::vector<double>& rates) {
  const double fastest = *std::max_element(rates.begin(), rates.end());
  const double hard = fastest > 0.0 ? 2.0 / fastest : limit_.hard;
  if (fastest > 0.0) {
    laws_.take_hold_over(0.6 * hard);
  }
  if (is_implicit()) {
    limit_.reason = "the theta scheme has no limit";
    return;
  }
  limit_.hard = hard;
  limit_.automatic = 0.6 * hard;
  limit_.reason = "explicit heat: largest eigenvalue of the nodal operator";
}

template <int Dim>
StepLimit CutCellHeat<Dim>::step_limit() const {
  StepLimit limit = limit_;
  if (adaptive_.are_long()) {
    limit.hard = std::numeric_limits<double>::infinity();
    limit.automatic = adaptive_.size();
    limit.stop = next_entry(time_);
    limit.even = true;
    limit.reason = adaptive_.reason();
    return limit;
  }
  if (!is_implicit()) {
    limit.automatic = laws_.step_since_jump(time_, limit.automatic);
    self_heating_.bound(limit);
  }
  return limit;
}

template <int Dim>
SurfaceTerm::Vector CutCellHeat<Dim>::gather(const System& system, std::span<const double> values) {
  SurfaceTerm::Vector some(static_cast<Eigen::Index>(system.unknown_place.size()));
  for (std::size_t k = 0; k < system.unknown_place.size(); ++k) {
    some[static_cast<Eigen::Index>(k)] = values[system.unknown_place[k]];
  }
  return some;
}

template <int Dim>
void CutCellHeat<Dim>::scatter(const System& system, const SurfaceTerm::Vector& some,
                               std::span<double> values) {
  for (std::size_t k = 0; k < system.unknown_place.size(); ++k) {
    values[system.unknown_place[k]] = some[static_cast<Eigen::Index>(k)];
  }
}

template <int Dim>
bool CutCellHeat<Dim>::is_linear(const Solved& one) const {
  return laws_.is_linear() &&
         std::none_of(one.part.sources.begin(), one.part.sources.end(), [&](const auto& own) {
           return problem_.bodies[own.body].source.is_function();
         });
}

template <int Dim>
StepReport CutCellHeat<Dim>::advance(const Step& step) {
  StepReport report{step.size, 0, 0.0};
  if (adaptive_.are_long()) {
    report = advance_adaptively(step);
    finish_step(step);
    return report;
  }
  if (!is_implicit()) {
    step_explicitly(step);
    finish_step(step);
    return report;
  }
  for (Solved& one : solved_) {
    const StepReport part = advance_implicitly(one, step);
    report.iterations = std::max(report.iterations, part.iterations);
    report.residual = std::max(report.residual, part.residual);
  }
  finish_step(step);
  return report;
}

template <int Dim>
void CutCellHeat<Dim>::take_explicit_step(const Step& step) {
  self_heating_.forget();
  for (Solved& one : solved_) {
    conduct(one, step);
    release_sources(one, step);
    exchange_with_surroundings(one, step);
    finish(one);
  }
  self_heating_.require_followed(step.size);
}

template <int Dim>
void CutCellHeat<Dim>::finish_step(const Step& step) {
  time_ = step.time + step.size;
  if (step.output_due || step.index % 128 == 0) {
    require_finite();
  }
  if (is_adaptive()) {
    choose_steps(step);
  }
}

template <int Dim>
void CutCellHeat<Dim>::conduct(Solved& one, const Step& step) {
  const double* inverse = one.inverse.data();
  const double* temperature = one.part.temperature.data();
  double* increment = one.increment.data();
  // Followers receive heat instead of a rise, and hand it on.
  one.part.conduction->multiply(temperature, [=](Index place, const auto& product) {
    for (std::size_t k = 0; k < product.size(); ++k) {
      increment[place + k] = -step.size * inverse[place + k] * product[k];
    }
  });
  std::vector<double> heat(laws_.size(), 0.0);  // J
  exchange_weakly(one, step, heat);
  one.part.followers.hand_on(one.increment, one.inverse);
  centre_weak_exchange(one, step.size, heat);
}

template <int Dim>
void CutCellHeat<Dim>::release_sources(Solved& one, const Step& step) {
  if (one.part.sources.empty()) {
    return;
  }
  const SourceRates given = source_rates(one.part, problem_.bodies, one.part.temperature, step.time,
                                         step.time + step.size);
  for (std::size_t place = 0; place < one.increment.size(); ++place) {
    if (const double capacity = one.part.capacity[place]; capacity > 0.0) {
      const double fall = given.fall.empty() ? 0.0 : given.fall[place];
      const double rise = rise_by_source(one.increment[place], step.size * given.power[place],
                                         step.size * fall, capacity);
      self_heating_.meet(fall, capacity);
      one.increment[place] += rise;
      source_ += capacity * rise;
    }
  }
}

template <int Dim>
void CutCellHeat<Dim>::find_self_heating(double time) {
  self_heating_.forget();
  for (const Solved& one : solved_) {
    if (!is_implicit() && !one.part.sources.empty()) {
      const SourceRates given =
          source_rates(one.part, problem_.bodies, one.part.temperature, time, time);
      for (std::size_t place = 0; place < given.fall.size(); ++place) {
        if (one.part.capacity[place] > 0.0) {
          self_heating_.meet(given.fall[place], one.part.capacity[place]);
        }
      }
    }
  }
}

template <int Dim>
void CutCellHeat<Dim>::finish(Solved& one) const {
  double* temperature = one.part.temperature.data();
  const double* increment = one.increment.data();
  parallel_for(
      static_cast<Index>(one.increment.size()),
      [=](Index place) { temperature[place] += increment[place]; }, Work::light);
  keep_in_range(one);
}

template <int Dim>
bool CutCellHeat<Dim>::keep_in_range(Solved& one) const {
  const bool strayed = one.range.restore(one.part, range_, one.part.temperature);
  one.part.followers.prolong(one.part.temperature);
  return strayed;
}

template class CutCellHeat<1>;
template class CutCellHeat<2>;
template class CutCellHeat<3>;

}  // namespace lapilli
