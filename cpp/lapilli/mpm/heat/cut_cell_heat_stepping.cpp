#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/cut_cell_heat.hpp"
#include "lapilli/mpm/heat/functions_in_time.hpp"

namespace lapilli {
namespace {

using Vector = SurfaceTerm::Vector;

// Steps between looks at how rates change, the first of them after half as many.
constexpr Index watch_every = 64;

bool is_look(Index step) { return (step + 1) % watch_every == watch_every / 2; }

/// Explicit steps that one implicit step of so many nodes takes the time of, its share of a factor
/// included: measured, at 1,300 to 20,000 nodes in the plane and 500 to 4,000 in space.
template <int Dim>
double worth_of_implicit_step(double nodes) {
  if constexpr (Dim == 1) {
    return 100.0;
  } else {
    return Dim == 2 ? std::clamp(200.0 * std::pow(nodes / 5000.0, 0.25), 100.0, 400.0)
                    : std::clamp(150.0 * nodes / 3000.0, 100.0, 1500.0);
  }
}

}  // namespace

template <int Dim>
void CutCellHeat<Dim>::begin_adaptive_steps() {
  double nodes = 0.0;
  for (const Solved& one : solved_) {
    nodes += static_cast<double>(one.part.capacity.size() - one.part.followers.count());
  }
  const double worth = worth_of_implicit_step<Dim>(nodes);
  adaptive_ = AdaptiveSteps(problem_.settings.tolerance, limit_.automatic, worth);
  lowest_ = std::isfinite(range_.low) ? range_.low : std::numeric_limits<double>::infinity();
  highest_ = std::isfinite(range_.high) ? range_.high : -std::numeric_limits<double>::infinity();
  widen_span();
}

template <int Dim>
void CutCellHeat<Dim>::follow_changes(double end, double longest) {
  end_ = end;
  if (is_adaptive()) {
    adaptive_.bound(std::min(longest, step_of_functions()));
  }
}

template <int Dim>
double CutCellHeat<Dim>::step_of_functions() {
  FunctionsInTime functions(end_);
  if (!has_functions(problem_)) {
    return functions.step();
  }
  for (Solved& one : solved_) {
    one.near.surface.evaluate(laws_, gather(one.near, one.part.temperature), 0.0, 0.0);
    for (std::size_t law = 0; law < laws_.size(); ++law) {
      const SurfaceSites& sites = one.near.surface.sites(law);
      for (const Value* value : values_of(laws_[law])) {
        functions.ask(*value, sites.position, sites.state);
      }
    }
    for (const auto& own : one.part.sources) {
      std::vector<double> state;
      for (const Index place : own.place) {
        state.push_back(one.part.temperature[place]);
      }
      functions.ask(problem_.bodies[own.body].source, own.position, state);
    }
  }
  return functions.step();
}

template <int Dim>
double CutCellHeat<Dim>::next_entry(double time) const {
  const double after = time * (1.0 + 1e-12);  // a step has ended at the entry
  double next = laws_.next_entry(after);
  for (const HeatBody& body : problem_.bodies) {
    next = std::min(next, body.source.next_entry(after));
  }
  return next;
}

template <int Dim>
double CutCellHeat<Dim>::last_jump() const {
  const double now = time_ * (1.0 + 1e-12);  // where a step has ended at an entry
  double jump = laws_.last_jump(now);
  for (const HeatBody& body : problem_.bodies) {
    jump = std::max(jump, body.source.last_jump(now));
  }
  return jump;
}

template <int Dim>
void CutCellHeat<Dim>::choose_steps(const Step& last) {
  // The first long step comes after a look at how explicit ones bend.
  if (!adaptive_.are_long() && !is_look(last.index)) {
    return;
  }
  const SteppingKind before = adaptive_.kind();
  if (before != SteppingKind::implicit) {
    adaptive_.allow_stages(rate_of_stages());  // as the surface is by now
  }
  if (adaptive_.choose(time_, last_jump(), next_entry(time_))) {
    change_steps(before, last.size);
  }
}

template <int Dim>
void CutCellHeat<Dim>::change_steps(SteppingKind before, double last) {
  if (before != SteppingKind::explicit_euler) {
    explicit_error_ = largest_error();
  }
  calming_ = 0;
  if (adaptive_.kind() == SteppingKind::implicit) {
    begin_implicit_steps(before, last);
    return;
  }
  end_long_steps();
  if (adaptive_.kind() == SteppingKind::stages) {
    begin_stages();
  }
}

template <int Dim>
void CutCellHeat<Dim>::end_long_steps() {
  for (Solved& one : solved_) {
    one.all.reset();
    one.rates = {};
    one.error.clear();
  }
}

template <int Dim>
void CutCellHeat<Dim>::begin_implicit_steps(SteppingKind before, double last) {
  for (Solved& one : solved_) {
    number_all_leaders(one);
    System& all = *one.all;
    const Vector capacity = gather(all, one.part.capacity);
    if (before == SteppingKind::stages) {
      all.rate = one.rates.rise.empty() ? Vector()
                                        : gather(all, one.rates.rise).cwiseProduct(capacity).eval();
      all.error = gather(all, one.error);
    } else {
      // Explicit steps take the surface a little differently: their own rate does not feel it.
      all.rate = gather(all, one.increment).cwiseProduct(capacity) / last;
      all.error =
          Vector::Constant(static_cast<Eigen::Index>(all.unknown_place.size()), explicit_error_);
    }
    one.rates = {};
    one.error.clear();
  }
}

template <int Dim>
StepsAhead CutCellHeat<Dim>::steps_ahead() const {
  constexpr int entries = 1000;  // the rest is as they are
  StepsAhead all;
  StepLimit limit = limit_;
  self_heating_.bound(limit);
  all.settled = std::isfinite(limit.automatic) ? limit.automatic : 0.0;
  if (!is_adaptive() || !std::isfinite(end_)) {
    return all;
  }
  AdaptiveSteps steps = adaptive_;
  if (!steps.are_long()) {
    steps.allow_stages(rate_of_stages());
  }
  all.next = steps.are_long() ? steps.cost() : 1.0;
  double now = time_, jump = last_jump();
  for (int entry = 0; now < end_ && entry < entries; ++entry) {
    const double next = std::min(end_, next_entry(now));
    steps.count(now, next, jump, all);
    now = next;
    jump = laws_.last_jump(now * (1.0 + 1e-12));
  }
  if (now < end_) {
    const double more = (end_ - time_) / (now - time_);
    all.number *= more;
    all.cost *= more;
  }
  return all;
}

template <int Dim>
void CutCellHeat<Dim>::widen_span() {
  for (const Solved& one : solved_) {
    for (std::size_t place = 0; place < one.part.capacity.size(); ++place) {
      if (one.part.capacity[place] > 0.0) {
        lowest_ = std::min(lowest_, one.part.temperature[place]);
        highest_ = std::max(highest_, one.part.temperature[place]);
      }
    }
  }
}

template <int Dim>
void CutCellHeat<Dim>::watch_curvature(Solved& one, const Step& step, double left) {
  if (is_look(step.index + 1)) {
    one.earlier = one.increment;
    for (double& rate : one.earlier) {
      rate /= step.size;
    }
  } else if (is_look(step.index) && !one.earlier.empty()) {
    // Explicit steps are late by dt/2 T'' t at most: exact for what decays and for powers of the
    // time; exchange that is taken in the middle of the step is late by less.
    double most = 0.0;
    for (std::size_t place = 0; place < one.increment.size(); ++place) {
      if (one.part.capacity[place] > 0.0) {
        most = std::max(most, std::abs(one.increment[place] / step.size - one.earlier[place]));
      }
    }
    explicit_error_ = left * 0.5 * most * (step.time + step.size - laws_.last_jump(step.time));
    one.earlier.clear();
    widen_span();
  }
}

template <int Dim>
double CutCellHeat<Dim>::largest_error() const {
  double error = adaptive_.are_long() ? 0.0 : explicit_error_;
  for (const Solved& one : solved_) {
    for (const double some : one.error) {
      error = std::max(error, std::abs(some));
    }
    if (one.all && one.all->error.size() > 0) {
      error = std::max(error, one.all->error.cwiseAbs().maxCoeff());
    }
  }
  return error;
}

template <int Dim>
double CutCellHeat<Dim>::temperature_span() const {
  const double rounding = 1e-9 * std::max(std::abs(lowest_), std::abs(highest_));
  return std::max({highest_ - lowest_, rounding, 1e-300});
}

#define LAPILLI_INSTANTIATE(Dim)                                                 \
  template void CutCellHeat<Dim>::begin_adaptive_steps();                        \
  template double CutCellHeat<Dim>::step_of_functions();                         \
  template void CutCellHeat<Dim>::follow_changes(double, double);                \
  template double CutCellHeat<Dim>::next_entry(double) const;                    \
  template void CutCellHeat<Dim>::choose_steps(const Step&);                     \
  template void CutCellHeat<Dim>::watch_curvature(Solved&, const Step&, double); \
  template void CutCellHeat<Dim>::end_long_steps();                              \
  template StepsAhead CutCellHeat<Dim>::steps_ahead() const;                     \
  template void CutCellHeat<Dim>::widen_span();                                  \
  template double CutCellHeat<Dim>::temperature_span() const;                    \
  template double CutCellHeat<Dim>::largest_error() const;
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
