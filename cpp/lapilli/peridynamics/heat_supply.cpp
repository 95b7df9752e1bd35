// What walls prescribe in a step, and what sources and the flow release.
#include <algorithm>
#include <cmath>

#include "lapilli/peridynamics/heat.hpp"

namespace lapilli {

void PeridynamicHeat::prescribe_walls(double begin, double end) {
  bool changed = !prescribed_;
  for (std::size_t k = 0; k < surface_.size(); ++k) {
    const FluidWallSettings& wall = walls_->walls()[k].settings;
    const WallState now{wall.temperature.mean(begin, end), wall.flux.mean(begin, end)};
    changed |= now.temperature != surface_[k].temperature;
    surface_[k] = now;
  }
  prescribed_ = true;
  if (!changed) {
    return;
  }
  for (Index i = 0; i < points_.size(); ++i) {
    const int k = walls_->wall(i);
    if (k >= 0 && walls_->walls()[k].settings.heat == WallHeat::temperature) {
      temperature_[i] = surface_[k].temperature;
    }
  }
}

void PeridynamicHeat::add_source(const FluidBody& body, double begin, double end) {
  const Value& source = body.source;
  if (source.is_constant() && source.at(0.0) == 0.0) {
    return;
  }
  std::vector<Index> rows;
  std::vector<Vec3> place;
  std::vector<double> state;
  double span = 1.0;
  for (Index i = 0; i < points_.size(); ++i) {
    if (points_.body()[i] == body.body) {
      rows.push_back(i);
      place.push_back(walls_->place(i));
      state.push_back(temperature_[i]);
      span = std::max(span, std::abs(temperature_[i]));
    }
  }
  std::vector<double> density(rows.size());
  source.evaluate_mean(place, state, begin, end, density);
  const auto volume = [&](Index i) { return capacity_[i] / fluid_.thermal.capacity(); };
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double power = density[k] * volume(rows[k]);
    rate_[rows[k]] += power;
    source_power_ += power;
  }
  if (!source.is_function()) {
    return;
  }
  const double rise = 1e-6 * span;
  for (double& value : state) {
    value += rise;
  }
  std::vector<double> warmer(rows.size());
  source.evaluate_mean(place, state, begin, end, warmer);
  source_fall_.resize(static_cast<std::size_t>(points_.size()), 0.0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double fall = (density[k] - warmer[k]) / rise * volume(rows[k]);
    source_fall_[rows[k]] = fall;
    self_heating_.meet(fall, capacity_[rows[k]]);
  }
}

void PeridynamicHeat::find_self_heating() {
  for (const FluidBody& body : fluid_.bodies) {
    if (body.source.is_function()) {
      add_source(body, 0.0, 0.0);
    }
  }
}

// The rates are rises here, K. A source that is steady over the step has given its heat; what it
// changes by with the temperature comes on top.
void PeridynamicHeat::follow_sources(double size) {
  for (Index i = 0; i < points_.size(); ++i) {
    if (capacity_[i] > 0.0 && source_fall_[i] != 0.0) {
      const double more = rise_by_source(rate_[i], 0.0, size * source_fall_[i], capacity_[i]);
      rate_[i] += more;
      source_power_ += more * capacity_[i] / size;
    }
  }
}

void PeridynamicHeat::add_dissipation() {
  if (dissipation_ == nullptr) {
    return;
  }
  for (Index i = 0; i < points_.size(); ++i) {
    if (walls_->wall(i) < 0) {
      const double power = (*dissipation_)[i] * capacity_[i] / fluid_.thermal.capacity();
      rate_[i] += power;
      dissipated_power_ += power;
    }
  }
}

}  // namespace lapilli
