// How large a step may be, and whether the motion gains energy that nobody put in.
#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"

namespace lapilli {

/// Since the start, J; what dissipates counts against it. Strain is half a step ahead of the force
/// that answers it: what that is worth is no gain.
template <int Dim>
double Dynamics<Dim>::energy_gained() const {
  const double contact = contacts_ ? contacts_->friction() + contacts_->impact() : 0.0;
  return contact - (flows_.transfer + flows_.strain + flows_.friction + flows_.impact +
                    flows_.damping + ahead_);
}

template <int Dim>
void Dynamics<Dim>::watch_energy(const PointSums& sums) {
  ahead_ = sums.work_ahead;
  const double gained = energy_gained();
  if (!watch_.add_step(sums.kinetic, sums.strain_work, gained, rounding())) {
    throw RunError(
        message("the motion has gained ", gained, " J that nothing put in, ",
                100.0 * gained / watch_.largest(), " % of its largest energy: dynamics.transfer ",
                name_of(data_.settings.transfer), " with ", name_of(data_.settings.stress_update),
                " and ", name_of(data_.shape),
                " functions is unstable here; blended_apic with musl and gimp, or a smaller "
                "dynamics.courant, may hold"));
  }
}

/// Two over the highest frequency that the grid can have under USL, at most that of one point
/// alone: c^2 sum |grad S|^2 / S, which is largest where its edge has just reached a node. MUSL
/// damps it.
template <int Dim>
double Dynamics<Dim>::shaking_step() const {
  if (data_.settings.stress_update == StressUpdate::musl || data_.shape == ShapeFunction::linear) {
    return std::numeric_limits<double>::infinity();
  }
  const double narrowest = *std::ranges::min_element(data_.half_widths);
  const double most = Dim * (2.0 / narrowest + 1.0 / (1.0 - narrowest));  // squared, in cells
  return 2.0 * data_.grid.cell_size() / wave_speed_ / std::sqrt(most);
}

/// Velocities are half a step behind places, so that a step that is cut for a frame gives or takes
/// energy: a hundred cuts are worth some percent of what vibrates. Steps of one size do not.
template <int Dim>
StepLimit Dynamics<Dim>::step_limit() const {
  const double h = data_.grid.cell_size(), safety = data_.settings.courant;
  const double crossing = h / (wave_speed_ + speed_ + (obstacles_ ? obstacles_->speed() : 0.0));
  const Value& factor = data_.settings.gravity_factor;
  const double g = place(data_.settings.gravity).norm() *
                   std::max(std::abs(factor.largest()), std::abs(factor.least()));
  const double fall = g > 0.0 ? std::sqrt(h / g) : std::numeric_limits<double>::infinity();
  // At the rate of the last step no point strains by more than a quarter in the next: what flows
  // without change of volume would turn inside out as well.
  const double straining =
      strain_rate_ > 0.0 ? 0.25 / strain_rate_ : std::numeric_limits<double>::infinity();
  const double shaking = shaking_step();
  StepLimit limit{.hard = std::min(crossing, fall),
                  .automatic = std::min({safety * crossing, safety * fall, straining, shaking}),
                  .reason = {},
                  .even = true};
  if (limit.automatic == safety * crossing) {
    limit.reason = message("explicit dynamics: a wave of ", wave_speed_, " m/s on points of ",
                           speed_, " m/s may cross one cell of ", h, " m; safety ", safety);
  } else if (limit.automatic == safety * fall) {
    limit.reason = message("explicit dynamics: a gravity of ", g,
                           " m/s^2 takes points across one cell of ", h, " m; safety ", safety);
  } else if (limit.automatic == straining) {
    limit.reason = message("explicit dynamics: points strain at ", strain_rate_, " 1/s");
  } else {
    limit.reason = message("explicit dynamics with usl: a wave of ", wave_speed_,
                           " m/s shakes the nodes at the edge of a point");
  }
  return limit;
}

template double Dynamics<2>::energy_gained() const;
template double Dynamics<3>::energy_gained() const;
template void Dynamics<2>::watch_energy(const PointSums&);
template void Dynamics<3>::watch_energy(const PointSums&);
template StepLimit Dynamics<2>::step_limit() const;
template StepLimit Dynamics<3>::step_limit() const;

}  // namespace lapilli
