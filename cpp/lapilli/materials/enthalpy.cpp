#include "lapilli/materials/enthalpy.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {

// The first segment is what holds below its temperature, with a constant slope.
RisingIntegral::RisingIntegral(double slope)
    : segments_{{0.0, 0.0, 0.0, slope, 0.0}, {0.0, 0.0, 0.0, slope, 0.0}} {}

RisingIntegral::RisingIntegral(const TemperatureTable& slope, double unit) {
  const auto& at = slope.temperatures;
  segments_.push_back({at.front(), 0.0, 0.0, slope.values.front() / unit, 0.0});
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    const double change = (slope.values[k + 1] - slope.values[k]) / (at[k + 1] - at[k]);
    segments_.push_back({at[k], 0.0, 0.0, slope.values[k] / unit, 0.5 * change / unit});
  }
  segments_.push_back({at.back(), 0.0, 0.0, slope.values.back() / unit, 0.0});
  sum_up();
}

std::size_t RisingIntegral::segment_up_to(double temperature) const {
  const auto beyond = std::ranges::upper_bound(segments_, temperature, {}, &Segment::temperature);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(beyond - segments_.begin(), 1) - 1);
}

std::size_t RisingIntegral::segment_below(double temperature) const {
  const auto beyond = std::ranges::lower_bound(segments_, temperature, {}, &Segment::temperature);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(beyond - segments_.begin(), 1) - 1);
}

void RisingIntegral::split(double temperature) {
  const Segment& first = segments_.front();
  if (temperature < first.temperature) {
    segments_.insert(segments_.begin(), 2, {temperature, 0.0, 0.0, first.start, 0.0});
    return;
  }
  const std::size_t k = segment_up_to(temperature);
  segments_.insert(segments_.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                   {temperature, 0.0, 0.0, slope(temperature), k > 0 ? segments_[k].bend : 0.0});
}

void RisingIntegral::add_rise(double begin, double end, double amount) {
  split(begin);
  if (end > begin) {
    split(end);
    for (std::size_t k = 1; k < segments_.size(); ++k) {
      if (segments_[k].temperature >= begin && segments_[k].temperature < end) {
        segments_[k].start += amount / (end - begin);
      }
    }
  } else {
    segments_[segment_up_to(begin)].rise += amount;
  }
  sum_up();
}

void RisingIntegral::sum_up() {
  segments_.front().value = 0.0;
  for (std::size_t k = 1; k < segments_.size(); ++k) {
    const Segment& before = segments_[k - 1];
    const double way = segments_[k].temperature - before.temperature;
    segments_[k].value =
        before.value + (before.start + before.bend * way) * way + segments_[k].rise;
  }
  origin_ = 0.0;
  origin_ = at(0.0);
}

double RisingIntegral::at(double temperature) const {
  const Segment& from = segments_[segment_below(temperature)];
  const double way = temperature - from.temperature;
  return from.value + (from.start + from.bend * way) * way - origin_;
}

double RisingIntegral::slope(double temperature) const {
  const Segment& from = segments_[segment_up_to(temperature)];
  return from.start + 2.0 * from.bend * (temperature - from.temperature);
}

RisingIntegral::Place RisingIntegral::inverse(double value) const {
  const double wanted = value + origin_;
  // Below the second segment the first one goes on for ever.
  const auto beyond = std::partition_point(
      segments_.begin() + 1, segments_.end(),
      [&](const Segment& segment) { return segment.value - segment.rise <= wanted; });
  const Segment& from = *(beyond - 1);
  const double left = wanted - from.value;
  if (beyond - 1 != segments_.begin() && left <= 0.0) {
    return {from.temperature, left < 0.0 ? 0.0 : 1.0 / from.start};
  }
  const double root = std::sqrt(std::max(0.0, from.start * from.start + 4.0 * from.bend * left));
  return {from.temperature + 2.0 * left / (from.start + root), 1.0 / root};
}

namespace {

RisingIntegral sensible_heat(const Thermal& material) {
  const TemperatureTable* table = material.specific_heat.table();
  return table ? RisingIntegral(*table, 1.0 / material.density)
               : RisingIntegral(material.density * material.specific_heat.constant());
}

}  // namespace

Enthalpy::Enthalpy(const Thermal& material)
    : stored_(sensible_heat(material)),
      begin_(material.melting_begins()),
      end_(material.melting_ends()),
      latent_(material.density * material.latent_heat) {
  if (material.melts()) {
    stored_.add_rise(begin_, end_, latent_);
  }
}

double Enthalpy::liquid_fraction(double temperature, double enthalpy) const {
  if (latent_ == 0.0) {
    return 0.0;
  }
  if (end_ > begin_) {
    return std::clamp((temperature - begin_) / (end_ - begin_), 0.0, 1.0);
  }
  return temperature != begin_ ? (temperature > begin_ ? 1.0 : 0.0)
                               : std::clamp((enthalpy - at(begin_)) / latent_, 0.0, 1.0);
}

RisingIntegral kirchhoff_potential(const Thermal& material) {
  const TemperatureTable* table = material.conductivity.table();
  return table ? RisingIntegral(*table, table->largest()) : RisingIntegral(1.0);
}

}  // namespace lapilli
