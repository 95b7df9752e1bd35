#include <algorithm>

#include "lapilli/mpm/heat/cut_cell_heat.hpp"

namespace lapilli {

template <int Dim>
double CutCellHeat<Dim>::time_since_entry(double time) const {
  const double now = time * (1.0 + 1e-12);  // where a step has ended at an entry
  double last = laws_.last_entry(now);
  for (const HeatBody& body : problem_.bodies) {
    last = std::max(last, body.source.last_entry(now));
  }
  return time - last;
}

template <int Dim>
void CutCellHeat<Dim>::step_explicitly(const Step& step) {
  if (!is_adaptive()) {
    take_explicit_step(step);
    return;
  }
  // One step is late by half of itself: extrapolated where that is more than half a percent of
  // what has happened since a table had an entry. Under conditions that stay, what it is late by
  // takes from the error of the cells: on squares the two cancel at a step of h^2 / (6 alpha).
  constexpr double short_enough = 0.01;
  const double since = time_since_entry(step.time) + step.size;
  const bool is_short = step.size < short_enough * since;
  if (is_short) {
    take_explicit_step(step);
  } else {
    take_extrapolated_step(step);
  }
  for (Solved& one : solved_) {
    watch_curvature(one, step, is_short ? 1.0 : std::min(1.0, step.size / since));
  }
}

template <int Dim>
void CutCellHeat<Dim>::take_extrapolated_step(const Step& step) {
  const auto temperatures = [&]() {
    std::vector<std::vector<double>> all;
    for (const Solved& one : solved_) {
      all.push_back(one.part.temperature);
    }
    return all;
  };
  const auto swap_solvers = [&]() {  // whose factors belong to steps of one size
    for (Solved& one : solved_) {
      std::swap(one.near.solver, one.solver_of_whole);
    }
  };
  const std::vector<std::vector<double>> start = temperatures();
  const ConditionAccount account = laws_.account();
  const double source = source_;
  swap_solvers();
  take_explicit_step(step);
  swap_solvers();
  const std::vector<std::vector<double>> once = temperatures();
  const ConditionAccount account_of_one = laws_.account();
  const double source_of_one = source_;
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    solved_[k].part.temperature = start[k];
  }
  laws_.account() = account;
  source_ = source;
  Step half = step;
  half.size = 0.5 * step.size;
  take_explicit_step(half);
  half.time += half.size;
  take_explicit_step(half);
  laws_.account().extrapolate(account_of_one);
  source_ += source_ - source_of_one;
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    Solved& one = solved_[k];
    std::vector<double>& now = one.part.temperature;
    for (std::size_t place = 0; place < now.size(); ++place) {
      now[place] += now[place] - once[k][place];
    }
    keep_in_range(one);
    for (std::size_t place = 0; place < now.size(); ++place) {
      one.increment[place] = now[place] - start[k][place];
    }
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                    \
  template double CutCellHeat<Dim>::time_since_entry(double) const; \
  template void CutCellHeat<Dim>::step_explicitly(const Step&);     \
  template void CutCellHeat<Dim>::take_extrapolated_step(const Step&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
