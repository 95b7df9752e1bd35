// Heat that goes on from another run or stage.
#include <numeric>

#include "lapilli/mpm/heat/particle_heat.hpp"

namespace lapilli {
namespace {

/// What points carry at the time of the state: what they had after the last step of heat, and its
/// rate over the part of the next one that is pending.
std::vector<double> carried_temperatures(const Archive& state) {
  std::vector<double> carried = state.read_numbers("heat/temperature");
  if (!state.contains("heat/sub_cycle/times")) {
    return carried;
  }
  const std::vector<double> change = state.read_numbers("heat/sub_cycle/change");
  const std::vector<double> times = state.read_numbers("heat/sub_cycle/times");
  const double pending = times[1], span = times[2];
  for (std::size_t row = 0; pending > 0.0 && span > 0.0 && row < carried.size(); ++row) {
    carried[row] += pending / span * change[row];
  }
  return carried;
}

}  // namespace

template <int Dim>
void ParticleHeat<Dim>::go_on(const PointStart& start) {
  const std::vector<double> mass = start.state->read_numbers("dynamics/mass");
  const bool knows_heat = start.state->contains("heat/temperature");
  const std::vector<double> carried =
      knows_heat ? carried_temperatures(*start.state) : std::vector<double>();
  std::vector<double> capacity(capacity_.values().begin(), capacity_.values().end());
  std::vector<double> temperature(temperature_.values().begin(), temperature_.values().end());
  for (Index row = 0; row < points_.size(); ++row) {
    const Index there = start.row[static_cast<std::size_t>(points_.id()[row])];
    if (there < 0) {
      continue;
    }
    const Thermal& material = problem_.bodies[points_.body()[row]].material;
    capacity[row] = mass[there] * material.capacity() / material.density;
    if (knows_heat) {
      temperature[row] = carried[there];
    }
  }
  start_with(capacity, temperature);
  if (affine_ && start.state->contains("heat/gradient")) {
    start.fetch("heat/gradient", points_, *gradient_);
  }
  obstacles_.go_on(start);
  bound_carried_step();
  limited_ordering_ = -1;
  bound_step();
  project_to_grid();
  const std::string ratios = "heat/laws/area_ratios";
  if (!laws_.empty() && start.same_heat_laws && start.state->contains(ratios + "/bodies")) {
    std::vector<int> laws(problem_.settings.boundaries.size());
    std::iota(laws.begin(), laws.end(), 0);  // bodies have moved away from their shapes
    laws_.compare_areas(AreaRatios::of_before(*start.state, ratios, start.body, laws));
    surface_found_ = {-1, -1};
    find_surface();
  }
  if (source_ && source_->depends_on_state()) {
    find_self_heating(start.time);
  }
  initial_ = balances().front().stored;
}

#define LAPILLI_INSTANTIATE(Dim) template void ParticleHeat<Dim>::go_on(const PointStart&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
