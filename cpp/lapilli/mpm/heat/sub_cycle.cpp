#include "lapilli/mpm/heat/sub_cycle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>

#include "lapilli/core/parallel.hpp"

namespace lapilli {

SubCycle::SubCycle(Points& points, double cell, Motion motion)
    : motion_(std::move(motion)), reach_(reach * cell), change_(points, 1) {}

double SubCycle::longest(double limit) const {
  constexpr double cost = 1.5;  // of a step of the motion, in steps of heat
  const double most = static_cast<double>(most_parts) * limit;
  if (limit > 4.0 * clock_size_) {
    return most;
  }
  const double ratio = std::min(motion_.step() / limit, static_cast<double>(most_parts));
  const double fit = std::floor(ratio * (1.0 + 1e-9));
  return fit < 1.0 || (cost + fit + 1.0) / ratio < (cost + fit) / fit ? most : fit * limit;
}

std::optional<SubCycle::Due> SubCycle::due(const Step& clock, double limit) {
  if (count_ == 0) {
    begin_ = clock.time;
    path_ = 0.0;
  }
  const double moves = clock.size * motion_.speed();
  clock_size_ = clock.size;
  ++count_;
  pending_ += clock.size;
  path_ += moves;
  const double next = pending_ + clock.size;
  if (!clock.last && count_ < planned_ && next <= own_share * limit &&
      next * exchange_ <= exchange_share && path_ + moves <= reach_) {
    return {};
  }
  Due due{{begin_, pending_, own_steps_, clock.output_due, clock.last}, 1};
  due.parts = std::max(Index{1}, static_cast<Index>(std::ceil(pending_ / limit * (1.0 - 1e-9))));
  planned_ = std::min(2 * planned_, most_steps);
  clock_steps_ += count_;
  own_steps_ += due.parts;
  count_ = 0;
  pending_ = 0.0;
  // A remainder before a stop says little of the rate: it is added to what came before.
  if (due.step.size >= 0.5 * span_ || due.step.index == 0) {
    span_ = 0.0;
    stand_still();
  }
  span_ += due.step.size;
  return due;
}

void SubCycle::before(const PointArray& temperature, std::span<const double> supplied) {
  parallel_for(static_cast<Index>(temperature.values().size()),
               [&](Index row) { change_[row] -= temperature[row]; });
  supply_.resize(supplied.size(), 0.0);
  std::ranges::transform(supply_, supplied, supply_.begin(), std::minus<>());
}

void SubCycle::after(const PointArray& temperature, std::span<const double> supplied,
                     double exchange) {
  exchange_ = exchange;
  parallel_for(static_cast<Index>(temperature.values().size()),
               [&](Index row) { change_[row] += temperature[row]; });
  std::ranges::transform(supply_, supplied, supply_.begin(), std::plus<>());
}

void SubCycle::stand_still() {
  std::ranges::fill(change_.values(), 0.0);
  std::ranges::fill(supply_, 0.0);
}

double SubCycle::mean_steps() const {
  return own_steps_ == 0 ? 1.0
                         : static_cast<double>(clock_steps_) / static_cast<double>(own_steps_);
}

std::string SubCycle::described() const {
  const double steps = mean_steps();
  std::ostringstream text;
  text << std::setprecision(3);
  if (steps < 1.0) {
    text << 1.0 / steps << " steps of heat in one of the motion";
  } else {
    text << "one step of heat for " << steps << " of the motion";
  }
  return text.str();
}

void SubCycle::save(Archive& archive) const {
  archive.write("heat/sub_cycle/change", change_.values());
  archive.write("heat/sub_cycle/supply", std::span<const double>(supply_));
  archive.write("heat/sub_cycle/times",
                std::array{begin_, pending_, span_, path_, exchange_, clock_size_});
  archive.write("heat/sub_cycle/steps", std::array{count_, planned_, clock_steps_, own_steps_});
}

void SubCycle::load(const Archive& archive) {
  archive.read("heat/sub_cycle/change", change_.values());
  supply_ = archive.read_numbers("heat/sub_cycle/supply");
  std::array<double, 6> times{};
  archive.read("heat/sub_cycle/times", std::span<double>(times));
  begin_ = times[0];
  pending_ = times[1];
  span_ = times[2];
  path_ = times[3];
  exchange_ = times[4];
  clock_size_ = times[5];
  std::array<Index, 4> steps{};
  archive.read("heat/sub_cycle/steps", std::span<Index>(steps));
  count_ = steps[0];
  planned_ = steps[1];
  clock_steps_ = steps[2];
  own_steps_ = steps[3];
}

}  // namespace lapilli
