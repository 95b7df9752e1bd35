#include <algorithm>
#include <stdexcept>

#include "lapilli/core/require.hpp"
#include "lapilli/core/step_refused.hpp"
#include "lapilli/core/step_stop.hpp"
#include "lapilli/mpm/quasi_static/quasi_static.hpp"

namespace lapilli {

template <int Dim>
StepLimit QuasiStatic<Dim>::step_limit() const {
  StepLimit limit;
  limit.reason = "load steps have no stable size: give time.steps";
  return limit;
}

template <int Dim>
StepReport QuasiStatic<Dim>::advance(const Step& step) {
  double end = steps_.end(step.time, step.size);
  for (int halvings = 0;; ++halvings, end = 0.5 * (step.time + end)) {
    try {
      report_ = attempt(step.time, end);
      report_.halvings = halvings;
      steps_.took(step.time, step.size);
      const bool whole = end == step.time + step.size;
      return {whole ? step.size : length_to(end, step.time), report_.newton.iterations,
              report_.newton.residual};
    } catch (const LoadStepFailed& error) {
      if (halvings == settings_.max_cutbacks) {
        throw StepRefused(message("load step failed after ", halvings, " halvings: ", error.what(),
                                  "; the last converged state is kept"));
      }
    } catch (const RunError& error) {
      throw StepRefused(message(error.what(), "; the last converged state is kept"));
    }
  }
}

/// One load step; changes nothing unless it converges.
template <int Dim>
typename QuasiStatic<Dim>::Report QuasiStatic<Dim>::attempt(double from, double to) {
  if (!is_reset_due()) {
    const auto scheme = reference_.scheme;
    try {
      return try_step(from, to, StepStop::stoppable());
    } catch (const StepStopped&) {
      reference_.scheme = scheme;  // it may have been made stiffer on the way
      throw;
    }
  }
  Archive before;
  reference_.save(before);
  const bool moved_far = moved_far_;
  try {
    std::unique_ptr<Interruption> stoppable = StepStop::stoppable();
    reset_grid(from);
    return try_step(from, to, std::move(stoppable));
  } catch (const std::runtime_error&) {
    choose_stiffness(moved_far);
    undo_reset(before);
    throw;
  }
}

template <int Dim>
void QuasiStatic<Dim>::undo_reset(const Archive& before) {
  reference_.scheme = scheme_;
  reference_.load(before);
  reference_.locate(grid_, points_, solids_.elastic(), averaged_, boundary_);
}

/// What a reset leaves out of balance: moved points integrate differently, and the walls of the new
/// grid hold nothing yet. It is taken up as the points move on; where nothing moves, nothing
/// changes. The new walls hold the hydrostatic pressure from the first: forces of the old ones
/// carry on without it.
template <int Dim>
void QuasiStatic<Dim>::settle_imbalance(double time) {
  const Loads<Dim> loads = collect_loads(time);
  const Equilibrium<Dim> equilibrium = equilibrium_under(loads);
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(system_.unknowns());
  reference_.imbalance = equilibrium.residual(still).force;
  const auto held = equilibrium.support_forces(still, static_cast<int>(boundary_.walls()));
  for (std::size_t w = 0; w < held.size(); ++w) {
    reference_.support_forces[w] -= held[w];
  }
  reference_.imbalance_due = false;
}

template <int Dim>
bool QuasiStatic<Dim>::is_reset_due() const {
  const double farthest = reference_.farthest(points_);
  return !reference_.located || (farthest > 0.0 && farthest >= reset_);
}

template <int Dim>
void QuasiStatic<Dim>::reset_grid(double time) {
  reference_.imbalance_due = relaxation_ > 0.0 && reference_.moved.size() > 0;
  reference_.start(points_, half_width_.get(), time);
  choose_stiffness(moved_far_ || farthest_moved() >= 0.5 * grid_.cell_size());
  reference_.scheme = scheme_;
  reference_.support_forces = support_forces_;
  reference_.locate(grid_, points_, solids_.elastic(), averaged_, boundary_);
}

#define LAPILLI_INSTANTIATE(Dim)                              \
  template StepLimit QuasiStatic<Dim>::step_limit() const;    \
  template StepReport QuasiStatic<Dim>::advance(const Step&); \
  template void QuasiStatic<Dim>::settle_imbalance(double);   \
  template bool QuasiStatic<Dim>::is_reset_due() const;       \
  template void QuasiStatic<Dim>::reset_grid(double);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
