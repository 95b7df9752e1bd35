#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/cut_cell_heat.hpp"
#include "lapilli/mpm/heat/cut_cell_heat_attempt.hpp"
#include "lapilli/mpm/heat/part_sources.hpp"

namespace lapilli {
namespace {

using Vector = SurfaceTerm::Vector;

// TR-BDF2 (Bank et al. 1985; error estimate of Hosea & Shampine 1996): the trapezoidal rule to
// `middle`, then a backward difference to the end; both solve the same matrix.
const double middle = 2.0 - std::sqrt(2.0);
const double implicit_weight = 0.5 * middle;          // of the last stage, in both formulas
const double earlier_weight = 0.25 * std::sqrt(2.0);  // of the first two in the second formula
const double error_weight = (-3.0 * middle * middle + 4.0 * middle - 2.0) / (6.0 * (2.0 - middle));

}  // namespace

/// C (trial - start) = known + weight (force(trial) - K trial), in J.
template <int Dim>
struct CutCellHeat<Dim>::Stage {
  const Vector& start;     // K
  const Vector& capacity;  // J/K
  Vector known;            // J
  double from, to;         // s, when laws are taken
  double weight;           // s
  bool linear;
};

template <int Dim>
Vector CutCellHeat<Dim>::rates(Solved& one, const Vector& at, double from, double to, double factor,
                               std::span<double> of_laws, double& of_sources) {
  System& all = *one.all;
  all.surface.evaluate(laws_, at, from, to);
  const Vector none = Vector::Zero(at.size());
  for (std::size_t law = 0; law < of_laws.size(); ++law) {
    of_laws[law] += factor * all.surface.heat(law, none);
  }
  Vector sum = factor * (all.surface.force() - all.conduction * at);
  if (!one.part.sources.empty()) {
    std::vector<double> nodal(one.part.temperature), heat(nodal.size(), 0.0);
    scatter(all, at, nodal);
    one.part.followers.prolong(nodal);
    const double span = to - from;  // sources are given as heat over a span
    of_sources += factor / span * source_heat(one.part, problem_.bodies, nodal, from, span, heat);
    sum += factor / span * gather(all, heat);
  }
  return sum;
}

template <int Dim>
bool CutCellHeat<Dim>::solve_stage(Solved& one, const Stage& stage, Vector& trial,
                                   int& iterations) {
  constexpr int most = 20;
  System& all = *one.all;
  std::vector<double> unused(laws_.size());
  double unused_source = 0.0;
  for (int iteration = 0; iteration < most; ++iteration) {
    const Vector residual =
        stage.known + rates(one, trial, stage.from, stage.to, stage.weight, unused, unused_source) -
        stage.capacity.cwiseProduct(trial - stage.start);
    const Vector rise = all.solver.solve(all.surface, stage.weight, residual);
    trial += rise;
    ++iterations;
    if (stage.linear ||
        rise.cwiseAbs().maxCoeff() <= 1e-12 * std::max(trial.cwiseAbs().maxCoeff(), 1e-300)) {
      return trial.allFinite();
    }
  }
  return false;
}

template <int Dim>
bool CutCellHeat<Dim>::try_implicitly(Solved& one, double begin, double size, Attempt& attempt) {
  System& all = *one.all;
  const Vector start = gather(all, one.part.temperature);
  const Vector capacity = gather(all, one.part.capacity);
  const bool linear = is_linear(one);
  // Steps end at the entries of tables, which are asked just inside of the step.
  const double instant = 1e-6 * size, end = begin + size, at_middle = begin + middle * size;
  const double weight = implicit_weight * size, before = earlier_weight * size;
  prepare(one, all, weight);
  attempt.of_laws.assign(laws_.size(), 0.0);

  Vector first =
      rates(one, start, begin, begin + instant, before, attempt.of_laws, attempt.of_sources) /
      before;
  if (all.rate.size() > 0) {
    first = all.rate;
  }
  Vector second = start;
  if (!solve_stage(
          one, {start, capacity, weight * first, at_middle, at_middle + instant, weight, linear},
          second, attempt.iterations)) {
    return false;
  }
  // The rate at a stage, from what it stored: exact where a stiff law leaves a small difference.
  const Vector at_second = capacity.cwiseProduct(second - start) / weight - first;
  rates(one, second, at_middle, at_middle + instant, before, attempt.of_laws, attempt.of_sources);
  Vector third = second + (1.0 - middle) / middle * (second - start);
  if (!linear || !third.allFinite()) {
    third = second;
  }
  if (!solve_stage(
          one, {start, capacity, before * (first + at_second), end - instant, end, weight, linear},
          third, attempt.iterations)) {
    return false;
  }
  const Vector stored = capacity.cwiseProduct(third - start);
  const Vector at_third = (stored - before * (first + at_second)) / weight;
  rates(one, third, end - instant, end, weight, attempt.of_laws, attempt.of_sources);
  attempt.given = stored.sum() - attempt.of_sources;

  const Vector bend =
      (error_weight * size) *
      (first / middle - at_second / (middle * (1.0 - middle)) + at_third / (1.0 - middle));
  const Vector local = all.solver.solve(all.surface, weight, bend);
  attempt.local = local.cwiseAbs().maxCoeff();
  // What was there decays about as a step does: (1 + .29 z)^-2 for exp(-z).
  Vector carried = all.error;
  for (int k = 0; k < 2; ++k) {
    carried = all.solver.solve(all.surface, weight, capacity.cwiseProduct(carried));
  }
  attempt.error = carried + local;
  attempt.end = third;
  return attempt.error.allFinite();
}

template <int Dim>
void CutCellHeat<Dim>::commit(Solved& one, const Attempt& attempt) {
  System& all = *one.all;
  scatter(all, attempt.end, one.part.temperature);
  all.error = attempt.error;
  all.rate.resize(0);
  keep_in_range(one);
  source_ += attempt.of_sources;
  laws_.account().book(attempt.of_laws, attempt.given);
}

template <int Dim>
bool CutCellHeat<Dim>::try_all(double begin, double size, std::vector<Attempt>& attempts,
                               double& error) {
  const double span = temperature_span();
  attempts.assign(solved_.size(), {});
  error = 0.0;
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    const bool taken = adaptive_.kind() == SteppingKind::stages
                           ? try_stages(solved_[k], begin, size, attempts[k])
                           : try_implicitly(solved_[k], begin, size, attempts[k]);
    if (!taken) {
      error = std::numeric_limits<double>::infinity();
      return false;
    }
    error = std::max(error, attempts[k].local / span);
  }
  return adaptive_.accepts(size, error) ||
         (adaptive_.kind() == SteppingKind::stages && calming_ > 0);
}

template <int Dim>
void CutCellHeat<Dim>::cover_explicitly(const Step& step, double begin, double size) {
  explicit_error_ = largest_error();
  find_self_heating(begin);
  const double end = begin + size;
  for (double done = 0.0; done < size;) {
    StepLimit limit = limit_;
    self_heating_.bound(limit);
    const double left = size - done, count = std::ceil(left / limit.automatic);
    step_explicitly({begin + done, left / count, 0, step.output_due});
    done = count > 1.0 ? done + left / count : size;
  }
  adaptive_.give_up(end);
  end_long_steps();
}

template <int Dim>
StepReport CutCellHeat<Dim>::advance_adaptively(const Step& step) {
  StepReport report{step.size, 0, 0.0};
  std::vector<Attempt> attempts;
  double error = 0.0, done = 0.0, size = step.size;
  while (done < step.size) {
    const double left = step.size - done;
    const bool is_last = left < size * (1.0 + 1e-6);
    size = is_last ? left : size;
    const bool in_stages = adaptive_.kind() == SteppingKind::stages;
    if (!in_stages && std::abs(size - factor_size_) <= 1e-9 * size) {
      size = factor_size_;  // but for rounding the same: the factor serves again
    }
    factor_size_ = in_stages ? factor_size_ : size;
    if (!try_all(step.time + done, size, attempts, error)) {
      size = adaptive_.shorter(size, error);
      if (!adaptive_.is_worth(size)) {
        cover_explicitly(step, step.time + done, left);
        return report;
      }
      continue;
    }
    if (in_stages) {
      commit_stages(size, attempts);
    }
    for (std::size_t k = 0; k < solved_.size() && !in_stages; ++k) {
      commit(solved_[k], attempts[k]);
      report.iterations = std::max(report.iterations, attempts[k].iterations);
    }
    widen_span();
    ++(in_stages ? staged_steps_ : implicit_steps_);
    adaptive_.follow(size, calming_ > 0 ? -1.0 : error);
    calming_ = std::max<Index>(0, calming_ - 1);
    done = is_last ? step.size : done + size;
  }
  return report;
}

#define LAPILLI_INSTANTIATE(Dim) \
  template StepReport CutCellHeat<Dim>::advance_adaptively(const Step&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
