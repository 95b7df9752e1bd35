#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/cut_cell_heat.hpp"
#include "lapilli/mpm/heat/part_sources.hpp"

namespace lapilli {

template <int Dim>
void CutCellHeat<Dim>::number_all_leaders(Solved& one) const {
  using Matrix = SurfaceTerm::Matrix;
  const HeatPart<Dim>& part = one.part;
  const auto size = static_cast<std::size_t>(part.rows->size());
  std::vector<Index> any(size, -1), unknown(size, -1);
  Index known = 0;
  one.all = std::make_unique<System>();
  System& all = *one.all;
  for (const auto& row : part.rows->rows()) {
    for (Index place = row.shift + row.begin; place < row.shift + row.end; ++place) {
      if (part.capacity[place] > 0.0) {
        unknown[place] = static_cast<Index>(all.unknown_place.size());
        all.unknown_place.push_back(place);
      }
      if (part.capacity[place] > 0.0 || part.followers.follows(place)) {
        any[place] = known++;
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(all.unknown_place.size());
  std::vector<Eigen::Triplet<double>> entries, lower;
  for (std::size_t place = 0; place < size; ++place) {
    const auto row = static_cast<int>(any[place]);
    if (unknown[place] >= 0) {
      entries.emplace_back(row, static_cast<int>(unknown[place]), 1.0);
    } else if (row >= 0) {
      for (const auto& leader : part.followers.leaders(static_cast<Index>(place))) {
        entries.emplace_back(row, static_cast<int>(unknown[leader.place]), leader.weight);
      }
    }
  }
  Matrix prolongation(known, count), triangle(known, known);
  prolongation.setFromTriplets(entries.begin(), entries.end());
  part.conduction->append_triplets(any, 1.0, lower);
  triangle.setFromTriplets(lower.begin(), lower.end());
  const Matrix whole = triangle.template selfadjointView<Eigen::Lower>();
  all.conduction = Matrix(prolongation.transpose()) * Matrix(whole * prolongation);

  // The surface counted the nodes near it; now it counts all.
  std::vector<Eigen::Triplet<double>> renumbered;
  for (std::size_t k = 0; k < part.unknown_place.size(); ++k) {
    renumbered.emplace_back(static_cast<int>(k), static_cast<int>(unknown[part.unknown_place[k]]),
                            1.0);
  }
  Matrix choice(static_cast<Eigen::Index>(part.unknown_place.size()), count);
  choice.setFromTriplets(renumbered.begin(), renumbered.end());
  std::vector<SurfaceTerm::Part> surface = one.part.surface;
  for (SurfaceTerm::Part& law : surface) {
    law.trace = SurfaceTerm::Trace(Matrix(law.trace) * choice);
  }
  // Weak laws have their couplings in the conduction: at each node the rest is left.
  const SurfaceTerm::Trace rows(prolongation);
  for (const WeakExchange& weak : one.weak) {
    SurfaceTerm::Part& law = surface[weak.law];
    law.sites.area = weak.area;
    law.sites.hold.clear();
    std::vector<Eigen::Triplet<double>> here;
    for (std::size_t k = 0; k < weak.place.size(); ++k) {
      here.emplace_back(static_cast<int>(k), static_cast<int>(any[weak.place[k]]), 1.0);
    }
    SurfaceTerm::Trace nodes(static_cast<Eigen::Index>(weak.place.size()), known);
    nodes.setFromTriplets(here.begin(), here.end());
    law.trace = SurfaceTerm::Trace(nodes * rows);
  }
  all.surface =
      SurfaceTerm(laws_, std::move(surface), count, std::vector<bool>(laws_.size(), false));
}

template <int Dim>
void CutCellHeat<Dim>::take_implicit_step(Solved& one, double begin, double size, double weight,
                                          StepReport& report) {
  using Vector = SurfaceTerm::Vector;
  System& all = *one.all;
  const double end = begin + size;
  const bool linear = is_linear(one);
  const int iterations_allowed = linear ? 1 : 30;
  const Vector start = gather(all, one.part.temperature);
  const Vector capacity = gather(all, one.part.capacity);
  std::vector<double> nodal(one.part.temperature);
  const auto sources_at = [&](const Vector& at, double factor, double& sum) {
    if (one.part.sources.empty()) {
      return Vector(Vector::Zero(at.size()));
    }
    scatter(all, at, nodal);
    one.part.followers.prolong(nodal);
    std::vector<double> heat(nodal.size(), 0.0);
    sum = factor * source_heat(one.part, problem_.bodies, nodal, begin, size, heat);
    return Vector(factor * gather(all, heat));
  };
  const Vector none = Vector::Zero(start.size());
  std::vector<double> of_laws(laws_.size(), 0.0);  // J
  const auto add_laws = [&](double factor) {
    for (std::size_t law = 0; law < of_laws.size(); ++law) {
      of_laws[law] += factor * all.surface.heat(law, none);
    }
  };
  // What the start of the step contributes.
  Vector known = none, sources = none;
  double source_start = 0.0, source_end = 0.0;
  if (weight < 1.0) {
    all.surface.evaluate(laws_, start, begin, end);
    known = (1.0 - weight) * size * all.surface.force();
    add_laws((1.0 - weight) * size);
    sources = sources_at(start, 1.0 - weight, source_start);
  }
  Vector trial = start;
  prepare(one, all, weight * size);
  double change = 0.0, scale = 0.0;
  Vector source_now = none;
  const auto balance = [&]() {
    return Vector(capacity.cwiseProduct(trial - start) +
                  size * (all.conduction * (start + weight * (trial - start))));
  };
  for (int iteration = 0; iteration < iterations_allowed; ++iteration) {
    all.surface.evaluate(laws_, trial, begin, end);
    source_now = sources_at(trial, weight, source_end);
    const Vector residual =
        known + weight * size * all.surface.force() + sources + source_now - balance();
    const Vector rise = all.solver.solve(all.surface, weight * size, residual);
    trial += rise;
    change = rise.cwiseAbs().maxCoeff();
    scale = trial.cwiseAbs().maxCoeff();
    report.iterations += std::max(1, all.solver.iterations());
    if (change <= 1e-13 * scale) {
      break;
    }
  }
  scatter(all, trial, nodal);
  one.range.restore(one.part, range_, nodal);
  if (weight < 1.0 && one.range.stray(nodal, range_) > 1e-10 * (range_.high - range_.low)) {
    report.accepted = 0.0;  // beyond what neighbours can take up
    return;
  }
  change = linear ? 0.0 : change;  // one solve is the answer
  if (change > 1e-8 * scale) {
    throw RunError(message("heat: the theta scheme stalled after ", iterations_allowed,
                           " iterations, change ", change, " K; take smaller steps"));
  }
  report.residual = std::max(report.residual, scale > 0.0 ? change / scale : 0.0);
  all.surface.evaluate(laws_, trial, begin, end);
  add_laws(weight * size);
  // Laws gave what nodes took up beyond sources: exact where a stiff law leaves a small difference
  // of large rates.
  source_ += source_start + source_end;
  laws_.account().book(of_laws, capacity.dot(trial - start) - (source_start + source_end));
  for (const Index place : all.unknown_place) {
    one.part.temperature[place] = nodal[place];
  }
  one.part.followers.prolong(one.part.temperature);
}

template <int Dim>
StepReport CutCellHeat<Dim>::advance_implicitly(Solved& one, const Step& step) {
  // The two steps after the start and after every jump of a table are taken as backward Euler
  // halves, which share the matrix of a Crank-Nicolson step and damp what it excites (Rannacher
  // 1984); so are steps that would leave the range.
  const double theta = problem_.settings.theta;
  bool damped = theta < 1.0 && (step.index < 2 ||
                                laws_.jumps_within(step.time - step.size, step.time + step.size));
  StepReport report{step.size, 0, 0.0};
  if (!damped) {
    take_implicit_step(one, step.time, step.size, theta, report);
    damped = report.accepted == 0.0;
    report.accepted = step.size;
  }
  for (int half = 0; half < 2 && damped; ++half) {
    const double size = 0.5 * step.size;
    take_implicit_step(one, step.time + half * size, size, 1.0, report);
  }
  return report;
}

#define LAPILLI_INSTANTIATE(Dim)                                                      \
  template void CutCellHeat<Dim>::number_all_leaders(Solved&) const;                  \
  template void CutCellHeat<Dim>::take_implicit_step(Solved&, double, double, double, \
                                                     StepReport&);                    \
  template StepReport CutCellHeat<Dim>::advance_implicitly(Solved&, const Step&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
