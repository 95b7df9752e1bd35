#include <algorithm>
#include <cmath>

#include "lapilli/mpm/heat/cut_cell_heat.hpp"
#include "lapilli/mpm/heat/part_sources.hpp"
#include "lapilli/mpm/heat/theta_steps.hpp"

namespace lapilli {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

/// Numbers of the nodes of a part by place, -1 for none.
struct NodeNumbers {
  std::vector<Index> unknown;  // of those that lead
  std::vector<Index> any;      // of all that lead or follow
  Index known = 0;             // how many these are
};

template <int Dim>
NodeNumbers number_nodes(const HeatPart<Dim>& part, std::vector<Index>& unknown_place) {
  const auto size = static_cast<std::size_t>(part.rows->size());
  NodeNumbers numbers{std::vector<Index>(size, -1), std::vector<Index>(size, -1)};
  for (const auto& row : part.rows->rows()) {
    for (Index place = row.shift + row.begin; place < row.shift + row.end; ++place) {
      if (part.capacity[place] > 0.0) {
        numbers.unknown[place] = static_cast<Index>(unknown_place.size());
        unknown_place.push_back(place);
      }
      if (part.capacity[place] > 0.0 || part.followers.follows(place)) {
        numbers.any[place] = numbers.known++;
      }
    }
  }
  return numbers;
}

/// Values at all nodes from those at leaders.
template <int Dim>
SurfaceTerm::Matrix prolongation_of(const HeatPart<Dim>& part, const NodeNumbers& numbers,
                                    Eigen::Index leaders) {
  Entries entries;
  for (std::size_t place = 0; place < numbers.any.size(); ++place) {
    const auto row = static_cast<int>(numbers.any[place]);
    if (numbers.unknown[place] >= 0) {
      entries.emplace_back(row, static_cast<int>(numbers.unknown[place]), 1.0);
    } else if (row >= 0) {
      for (const auto& leader : part.followers.leaders(static_cast<Index>(place))) {
        entries.emplace_back(row, static_cast<int>(numbers.unknown[leader.place]), leader.weight);
      }
    }
  }
  SurfaceTerm::Matrix made(numbers.known, leaders);
  made.setFromTriplets(entries.begin(), entries.end());
  return made;
}

/// Picks from values by `number` those of some places.
SurfaceTerm::Matrix choice_of(std::span<const Index> places, const std::vector<Index>& number,
                              Eigen::Index count) {
  Entries entries;
  for (std::size_t k = 0; k < places.size(); ++k) {
    entries.emplace_back(static_cast<int>(k), static_cast<int>(number[places[k]]), 1.0);
  }
  SurfaceTerm::Matrix made(static_cast<Eigen::Index>(places.size()), count);
  made.setFromTriplets(entries.begin(), entries.end());
  return made;
}

}  // namespace

template <int Dim>
void CutCellHeat<Dim>::number_all_leaders(Solved& one) const {
  using Matrix = SurfaceTerm::Matrix;
  const HeatPart<Dim>& part = one.part;
  one.all = std::make_unique<System>();
  System& all = *one.all;
  const NodeNumbers numbers = number_nodes(part, all.unknown_place);
  const auto count = static_cast<Eigen::Index>(all.unknown_place.size());
  const Matrix prolongation = prolongation_of(part, numbers, count);
  Entries lower;
  part.conduction->append_triplets(numbers.any, 1.0, lower);
  Matrix triangle(numbers.known, numbers.known);
  triangle.setFromTriplets(lower.begin(), lower.end());
  const Matrix whole = triangle.template selfadjointView<Eigen::Lower>();
  all.conduction = Matrix(prolongation.transpose()) * Matrix(whole * prolongation);

  // The surface counted the nodes near it; now it counts all.
  const Matrix near = choice_of(part.unknown_place, numbers.unknown, count);
  std::vector<SurfaceTerm::Part> surface = part.surface;
  for (SurfaceTerm::Part& law : surface) {
    law.trace = SurfaceTerm::Trace(Matrix(law.trace) * near);
  }
  // Weak laws have their couplings in the conduction: at each node the rest is left.
  for (const WeakExchange& weak : one.weak) {
    SurfaceTerm::Part& law = surface[weak.law];
    law.sites.area = weak.area;
    law.sites.hold.clear();
    law.trace =
        SurfaceTerm::Trace(choice_of(weak.place, numbers.any, numbers.known) * prolongation);
  }
  all.surface =
      SurfaceTerm(laws_, std::move(surface), count, std::vector<bool>(laws_.size(), false));
}

/// One step of the theta scheme in one part: C d = dt (-K (T + theta d) + (1 - theta) rate(T) +
/// theta rate(T + d)) with d the rise of the temperatures T.
template <int Dim>
class CutCellHeat<Dim>::ThetaStep {
  using Vector = SurfaceTerm::Vector;

 public:
  ThetaStep(CutCellHeat& heat, Solved& one, double begin, double size, double theta)
      : heat_(heat),
        one_(one),
        all_(*one.all),
        begin_(begin),
        size_(size),
        theta_(theta),
        start_(gather(all_, one.part.temperature)),
        capacity_(gather(all_, one.part.capacity)),
        none_(Vector::Zero(start_.size())),
        trial_(start_),
        known_(none_),
        sources_(none_),
        nodal_(one.part.temperature),
        of_laws_(heat.laws_.size(), 0.0) {}

  /// Returns whether the step was taken: not if it left the range.
  bool take(StepReport& report) {
    if (theta_ < 1.0) {
      evaluate(start_);
      known_ = (1.0 - theta_) * size_ * all_.surface.force();
      add_laws((1.0 - theta_) * size_);
      sources_ = sources_at(start_, 1.0 - theta_, at_start_);
    }
    const Change last = solve(report);
    scatter(all_, trial_, nodal_);
    one_.range.restore(one_.part, heat_.range_, nodal_);
    const TemperatureRange& range = heat_.range_;
    if (theta_ < 1.0 && one_.range.stray(nodal_, range) > 1e-10 * (range.high - range.low)) {
      return false;  // beyond what neighbours can take up
    }
    report.residual = std::max(report.residual, converged_share(last.change, last.scale));
    book();
    return true;
  }

 private:
  struct Change {  // K, of the last iteration
    double change = 0.0, scale = 0.0;
  };

  void evaluate(const Vector& at) {
    all_.surface.evaluate(heat_.laws_, at, begin_, begin_ + size_);
  }

  void add_laws(double factor) {
    for (std::size_t law = 0; law < of_laws_.size(); ++law) {
      of_laws_[law] += factor * all_.surface.heat(law, none_);
    }
  }

  /// `factor` times the heat of sources, J; it adds up to `sum`.
  Vector sources_at(const Vector& at, double factor, double& sum) {
    if (one_.part.sources.empty()) {
      return none_;
    }
    scatter(all_, at, nodal_);
    one_.part.followers.prolong(nodal_);
    std::vector<double> heat(nodal_.size(), 0.0);
    sum = factor * source_heat(one_.part, heat_.problem_.bodies, nodal_, begin_, size_, heat);
    return factor * gather(all_, heat);
  }

  Change solve(StepReport& report) {
    heat_.prepare(one_, all_, theta_ * size_);
    const bool linear = heat_.is_linear(one_);
    Change last;
    for (int iteration = 0; iteration < (linear ? 1 : theta_iterations); ++iteration) {
      evaluate(trial_);
      const Vector source_now = sources_at(trial_, theta_, at_end_);
      const Vector taken_up = capacity_.cwiseProduct(trial_ - start_) +
                              size_ * (all_.conduction * (start_ + theta_ * (trial_ - start_)));
      const Vector residual =
          known_ + theta_ * size_ * all_.surface.force() + sources_ + source_now - taken_up;
      const Vector rise = all_.solver.solve(all_.surface, theta_ * size_, residual);
      trial_ += rise;
      last = {rise.cwiseAbs().maxCoeff(), trial_.cwiseAbs().maxCoeff()};
      report.iterations += std::max(1, all_.solver.iterations());
      if (last.change <= 1e-13 * last.scale) {
        break;
      }
    }
    last.change = linear ? 0.0 : last.change;  // one solve is the answer
    return last;
  }

  void book() {
    evaluate(trial_);
    add_laws(theta_ * size_);
    // Laws gave what nodes took up beyond sources: exact where a stiff law leaves a small
    // difference of large rates.
    heat_.source_ += at_start_ + at_end_;
    heat_.laws_.account().book(of_laws_, capacity_.dot(trial_ - start_) - (at_start_ + at_end_));
    for (const Index place : all_.unknown_place) {
      one_.part.temperature[place] = nodal_[place];
    }
    one_.part.followers.prolong(one_.part.temperature);
  }

  CutCellHeat& heat_;
  Solved& one_;
  System& all_;
  double begin_, size_, theta_;
  const Vector start_, capacity_, none_;
  Vector trial_;
  Vector known_, sources_;                // J, what laws and sources gave at the start
  double at_start_ = 0.0, at_end_ = 0.0;  // J, by sources
  std::vector<double> nodal_;
  std::vector<double> of_laws_;  // J
};

template <int Dim>
StepReport CutCellHeat<Dim>::advance_implicitly(Solved& one, const Step& step) {
  const double theta = problem_.settings.theta;
  bool damped = is_damped(theta, step, laws_);  // and where a step would leave the range
  StepReport report{step.size, 0, 0.0};
  if (!damped) {
    damped = !ThetaStep(*this, one, step.time, step.size, theta).take(report);
  }
  for (int half = 0; half < 2 && damped; ++half) {
    const double size = 0.5 * step.size;
    ThetaStep(*this, one, step.time + half * size, size, 1.0).take(report);
  }
  return report;
}

#define LAPILLI_INSTANTIATE(Dim)                                     \
  template void CutCellHeat<Dim>::number_all_leaders(Solved&) const; \
  template StepReport CutCellHeat<Dim>::advance_implicitly(Solved&, const Step&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
