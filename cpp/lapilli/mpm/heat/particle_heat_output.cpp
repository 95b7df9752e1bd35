#include "lapilli/mpm/heat/particle_heat.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/heat_balance.hpp"

namespace lapilli {

template <int Dim>
void ParticleHeat<Dim>::make_room_to_show() {
  if (!output_temperature_) {
    output_temperature_ = std::make_unique<PointArray>(points_, 1);
    output_flux_ = std::make_unique<PointArray>(points_, Dim);
  }
}

template <int Dim>
void ParticleHeat<Dim>::show(const std::vector<double>& nodal) {
  make_room_to_show();
  carrier().interpolate(points_, nodal, output_temperature_->data(), output_flux_->data());
  output_is_current_ = true;
}

template <int Dim>
void ParticleHeat<Dim>::require_finite() const {
  for (Index row = 0; row < points_.size(); ++row) {
    if (!std::isfinite(temperature_[row])) {
      throw RunError(message(
          "heat: temperature of point ", points_.id()[row],
          " is not finite; a boundary condition or source gave such a value, or the step is "
          "too large for it"));
    }
  }
}

template <int Dim>
void ParticleHeat<Dim>::require_in_range() const {
  std::atomic<Index> stray = -1;
  const double low = range_.low, high = range_.high;
  grid_.for_active_nodes([&](Index begin, Index end) {
    for (Index node = begin; node < end; ++node) {
      const double value = grid_.temperature[node];
      if (!(value >= low && value <= high) && grid_.capacity[node] > 0.0) {
        stray.store(node, std::memory_order_relaxed);
      }
    }
  });
  if (stray >= 0) {
    const Index node = stray;
    require_finite();
    throw RunError(message("heat: ", grid_.temperature[node], " at (",
                           problem_.grid.node_position(node).transpose(),
                           ") is far beyond all that the scene can reach, ", low, " to ", high,
                           " at the most: the step is too large for its conditions"));
  }
}

template <int Dim>
void ParticleHeat<Dim>::refresh_output() {
  if (!output_is_current_) {
    order_.update(points_);
    if (sub_cycle_) {
      project_to_grid(temperature_now().data());
    } else {
      project_to_grid();
    }
    show(carrier().temperature);
  }
  require_finite();
}

template <int Dim>
std::vector<Field> ParticleHeat<Dim>::fields() {
  if (!output_temperature_) {
    refresh_output();
  }
  if (output_carried_) {
    std::ranges::copy(temperature_now(), output_carried_->data());
  }
  return {
      {"temperature", "K", 1, output_temperature_->values()},
      {"temperature_carried", "K", 1, (output_carried_ ? *output_carried_ : temperature_).values()},
      {"heat_flux", "W/m^2", Dim, output_flux_->values()}};
}

template <int Dim>
std::vector<Balance> ParticleHeat<Dim>::balances() const {
  Balance balance{"heat", "J", initial_, 0.0, laws_.entries(), 0.0};
  if (source_) {
    balance.entries.push_back({"source", source_->booked()});
  }
  std::ranges::move(obstacles_.entries(), std::back_inserter(balance.entries));
  const bool ahead = sub_cycle_ && sub_cycle_->ahead() > 0.0;
  for (std::size_t k = 0; ahead && k < balance.entries.size(); ++k) {
    balance.entries[k].in += sub_cycle_->ahead() * sub_cycle_->supply()[k];
  }
  if (books_plastic_) {
    balance.entries.push_back({"plastic work", plastic_});
  }
  if (books_removed_) {
    balance.entries.push_back({"removed points", -removed_});
  }
  if (ahead) {
    add_stored_heat(capacity_.values(), temperature_now(), balance);
  } else {
    add_stored_heat(capacity_.values(), temperature_.values(), balance);
  }
  return {balance};
}

template <int Dim>
std::vector<double> ParticleHeat<Dim>::stored_in(std::span<const Index> rows) const {
  const bool ahead = sub_cycle_ && sub_cycle_->ahead() > 0.0;
  const std::vector<double> pending = ahead ? temperature_now() : std::vector<double>();
  double heat = 0.0;
  for (const Index row : rows) {
    heat += capacity_[row] * (ahead ? pending[row] : temperature_[row]);
  }
  return {heat};
}

template <int Dim>
void ParticleHeat<Dim>::release(std::span<const Index> rows) {
  for (const Index row : rows) {
    removed_ += capacity_[row] * temperature_[row];
  }
  if (sub_cycle_) {
    sub_cycle_->stand_still();
  }
}

template <int Dim>
std::vector<std::pair<std::string, double>> ParticleHeat<Dim>::diagnostics() const {
  auto all = surface_diagnostics(laws_, negative_share_);
  std::ranges::move(obstacles_.diagnostics(), std::back_inserter(all));
  if (fields_) {
    std::ranges::move(fields_->diagnostics(), std::back_inserter(all));
  }
  if (sub_cycle_) {
    all.emplace_back("steps_per_heat_step", sub_cycle_->mean_steps());
  }
  return all;
}

template <int Dim>
void ParticleHeat<Dim>::save(Archive& archive) const {
  archive.write("heat/temperature", temperature_.values());
  archive.write("heat/capacity", capacity_.values());
  if (gradient_) {
    archive.write("heat/gradient", std::span<const double>(std::as_const(*gradient_).values()));
  }
  order_.save(archive, "heat/strips");
  laws_.save(archive, "heat/laws");
  obstacles_.save(archive);
  if (fields_) {
    fields_->save(archive);
  }
  if (surface_) {
    surface_->save(archive, "heat/outside");
  }
  if (sub_cycle_) {
    sub_cycle_->save(archive);
  }
  archive.write("heat/initial", initial_);
  archive.write("heat/self_heating", self_heating_.rate());
  archive.write("heat/plastic", plastic_);
  if (books_removed_) {
    archive.write("heat/removed", removed_);
  }
  archive.write("heat/source", source_ ? source_->booked() : 0.0);
  // Points that others have sorted since want another bound.
  const double bounded = limited_ordering_ == points_.ordering() ? 1.0 : 0.0;
  archive.write("heat/limit", std::array{limit_.hard, limit_.automatic, bounded});
  archive.write("heat/shown", output_is_current_ ? Index{1} : Index{0});
  if (output_is_current_) {
    archive.write("heat/output_temperature", std::as_const(*output_temperature_).values());
    archive.write("heat/output_flux", std::as_const(*output_flux_).values());
  }
}

template <int Dim>
void ParticleHeat<Dim>::load(const Archive& archive) {
  archive.read("heat/temperature", temperature_.values());
  archive.read("heat/capacity", capacity_.values());
  if (gradient_) {
    archive.read("heat/gradient", gradient_->values());
  }
  order_.load(archive, "heat/strips");
  laws_.load(archive, "heat/laws");
  obstacles_.load(archive);
  if (fields_) {
    fields_->load(archive);
  }
  if (surface_) {
    surface_->load(archive, "heat/outside");
  }
  if (sub_cycle_) {
    sub_cycle_->load(archive);
  }
  initial_ = archive.read_number("heat/initial");
  plastic_ = archive.read_number("heat/plastic");
  if (books_removed_) {
    removed_ = archive.read_number("heat/removed");
  }
  self_heating_.set_rate(archive.read_number("heat/self_heating"));
  range_ = plastic_ != 0.0 ? TemperatureRange{} : range_;
  if (source_) {
    source_->set_booked(archive.read_number("heat/source"));
  }
  std::array<double, 3> limits{};
  archive.read("heat/limit", std::span<double>(limits));
  limit_.hard = limits[0];
  limit_.automatic = limits[1];
  limited_ordering_ = limits[2] != 0.0 ? points_.ordering() : -1;
  output_is_current_ = archive.read_index("heat/shown") != 0;
  if (output_is_current_) {
    make_room_to_show();
    archive.read("heat/output_temperature", output_temperature_->values());
    archive.read("heat/output_flux", output_flux_->values());
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                               \
  template void ParticleHeat<Dim>::require_finite() const;                                     \
  template void ParticleHeat<Dim>::require_in_range() const;                                   \
  template void ParticleHeat<Dim>::make_room_to_show();                                        \
  template void ParticleHeat<Dim>::show(const std::vector<double>& nodal);                     \
  template void ParticleHeat<Dim>::refresh_output();                                           \
  template std::vector<Field> ParticleHeat<Dim>::fields();                                     \
  template std::vector<Balance> ParticleHeat<Dim>::balances() const;                           \
  template void ParticleHeat<Dim>::release(std::span<const Index>);                            \
  template std::vector<std::pair<std::string, double>> ParticleHeat<Dim>::diagnostics() const; \
  template std::vector<double> ParticleHeat<Dim>::stored_in(std::span<const Index>) const;     \
  template void ParticleHeat<Dim>::save(Archive& archive) const;                               \
  template void ParticleHeat<Dim>::load(const Archive& archive);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
