// When heat takes a step, and what it is between two.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapilli/core/parallel.hpp"
#include "lapilli/mpm/heat/common_nodes.hpp"
#include "lapilli/mpm/heat/functions_in_time.hpp"
#include "lapilli/mpm/heat/particle_heat.hpp"
#include "lapilli/mpm/heat/step_bound.hpp"

namespace lapilli {
namespace {

/// Whether steps of heat may be long unasked: nobody chose the step, the transfer smooths by the
/// time and not by the step, and there is no function, which nobody knows to change how fast.
template <int Dim>
bool bears_long_steps(const HeatProblem<Dim>& problem, HeatTransfer transfer) {
  return !problem.fixed_steps &&
         (transfer == HeatTransfer::affine || transfer == HeatTransfer::flip) &&
         !has_functions(problem);
}

}  // namespace

template <int Dim>
void ParticleHeat<Dim>::follow(SubCycle::Motion motion) {
  if (problem_.settings.subcycling.value_or(bears_long_steps(problem_, transfer_))) {
    sub_cycle_ = std::make_unique<SubCycle>(points_, problem_.grid.cell_size(), std::move(motion));
    output_carried_ = std::make_unique<PointArray>(points_, 1);
  }
}

template <int Dim>
void ParticleHeat<Dim>::touch(std::vector<FindFeet<Dim>> feet) {
  obstacles_.follow(std::move(feet));
  surface_found_ = {-1, -1};
}

template <int Dim>
void ParticleHeat<Dim>::separate(const NodeFields<Dim>& fields, FindTouches touches) {
  fields_ = std::make_unique<HeatFields<Dim>>(problem_, coefficients_, grid_.has_surface(), fields,
                                              std::move(touches));
  limited_ordering_ = -1;
  bound_step();
  project_to_grid();
}

/// The least of the fields, each without the others.
template <int Dim>
StepLimit ParticleHeat<Dim>::separate_limit() const {
  StepLimit least;
  for (const std::vector<std::size_t>& bodies : fields_->bodies()) {
    const std::unique_ptr<Points> some = points_of(points_, bodies);
    std::vector<double> capacity;
    for (Index row = 0; row < points_.size(); ++row) {
      if (std::ranges::find(bodies, static_cast<std::size_t>(points_.body()[row])) !=
          bodies.end()) {
        capacity.push_back(capacity_[row]);
      }
    }
    const StepLimit limit =
        explicit_step_limit(*some, problem_, coefficients_, capacity, transfer_);
    least = limit.hard < least.hard ? limit : least;
  }
  return least;
}

template <int Dim>
StepLimit ParticleHeat<Dim>::step_limit() const {
  StepLimit limit = own_limit();
  limit.even = true;
  if (sub_cycle_) {
    limit.hard *= SubCycle::most_parts;
    limit.automatic = sub_cycle_->longest(limit.automatic);
  }
  return limit;
}

template <int Dim>
StepLimit ParticleHeat<Dim>::own_limit() const {
  StepLimit limit = limit_;
  self_heating_.bound(limit);
  return limit;
}

template <int Dim>
void ParticleHeat<Dim>::take_due(const SubCycle::Due& due) {
  sub_cycle_->before(temperature_, supplied());
  Step part = due.step;
  part.size /= static_cast<double>(due.parts);
  for (Index taken = 1; taken <= due.parts; ++taken) {
    part.output_due = due.step.output_due && taken == due.parts;
    take_step(part);
    part.time += part.size;
  }
  sub_cycle_->after(temperature_, supplied(), exchange_rate());
}

/// How fast nodes come to the temperature of their surroundings, 1/s: slope over capacity, the mean
/// over the nodes of a law, however little of some is filled; the largest of all laws.
template <int Dim>
double ParticleHeat<Dim>::exchange_rate() const {
  const bool at_points = problem_.settings.method == FluxMethod::particle;
  double rate = obstacles_.rate();
  for (const auto& n : laws_.nodes()) {
    double slope = 0.0, capacity = 0.0;
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      slope += n.slope[k];
      capacity += at_points ? capacity_[n.node[k]] : grid_.capacity[n.node[k]];
    }
    rate = capacity > 0.0 ? std::max(rate, slope / capacity) : rate;
  }
  return rate;
}

/// By entry of the balance, J.
template <int Dim>
std::vector<double> ParticleHeat<Dim>::supplied() const {
  std::vector<double> heat;
  for (const Balance::Entry& entry : laws_.entries()) {
    heat.push_back(entry.in);
  }
  if (source_) {
    heat.push_back(source_->booked());
  }
  for (const Balance::Entry& entry : obstacles_.entries()) {
    heat.push_back(entry.in);
  }
  return heat;
}

/// What points carry at the time of the clock.
template <int Dim>
std::vector<double> ParticleHeat<Dim>::temperature_now() const {
  std::vector<double> now(temperature_.values().begin(), temperature_.values().end());
  const double ahead = sub_cycle_->ahead();
  const PointArray& change = sub_cycle_->change();
  parallel_for(
      points_.size(), [&](Index row) { now[row] += ahead * change[row]; }, Work::light);
  return now;
}

template <int Dim>
std::vector<std::string> ParticleHeat<Dim>::modelled() const {
  std::vector<std::string> all;
  if (sub_cycle_) {
    all.push_back(sub_cycle_->described());
  }
  if (fields_) {
    all.emplace_back("heat between bodies where they touch");
  } else if (problem_.bodies.size() > 1) {
    all.emplace_back("heat between bodies less than 1.5 cells apart, as if they touched");
  }
  return all;
}

template <int Dim>
std::vector<Note> ParticleHeat<Dim>::warnings() const {
  std::vector<std::size_t> all(problem_.bodies.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  using Fields = std::vector<std::vector<std::size_t>>;
  const Fields together = fields_ ? fields_->bodies() : Fields{all};
  const double cell = problem_.grid.cell_size();
  std::vector<Note> notes = common_nodes(together, problem_.bodies, cell);
  std::ranges::copy(unlike_contacts(together, problem_.bodies, cell), std::back_inserter(notes));
  return notes;
}

#define LAPILLI_INSTANTIATE(Dim)                                                  \
  template void ParticleHeat<Dim>::follow(SubCycle::Motion);                      \
  template void ParticleHeat<Dim>::separate(const NodeFields<Dim>&, FindTouches); \
  template StepLimit ParticleHeat<Dim>::separate_limit() const;                   \
  template void ParticleHeat<Dim>::touch(std::vector<FindFeet<Dim>>);             \
  template StepLimit ParticleHeat<Dim>::step_limit() const;                       \
  template StepLimit ParticleHeat<Dim>::own_limit() const;                        \
  template void ParticleHeat<Dim>::take_due(const SubCycle::Due&);                \
  template double ParticleHeat<Dim>::exchange_rate() const;                       \
  template std::vector<double> ParticleHeat<Dim>::supplied() const;               \
  template std::vector<double> ParticleHeat<Dim>::temperature_now() const;        \
  template std::vector<Note> ParticleHeat<Dim>::warnings() const;                 \
  template std::vector<std::string> ParticleHeat<Dim>::modelled() const;
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
