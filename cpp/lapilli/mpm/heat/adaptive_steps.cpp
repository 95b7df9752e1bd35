#include "lapilli/mpm/heat/adaptive_steps.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/chebyshev_stages.hpp"

namespace lapilli {
namespace {

// A step of this share of the time since the start has an error of a fifth of 1e-4 of what has
// changed, where temperatures go as roots of the time.
constexpr double share_at_1e_4 = 0.08;
constexpr double part_of_a_step = 0.2;  // of the tolerance

// Measured: explicit steps that a stage takes the time of.
constexpr double cost_of_stage = 1.7;
constexpr int most_stages = 1000;  // beyond, rounding grows with their square

// Stages are taken where they cost a quarter of the explicit steps, from the first of a length that
// three of them bear: what explicit steps are late by takes from the error of the cells, and leaves
// a third of it (ring, square, rod), which smaller cells would cost as much to reach.
constexpr double price_of_stages = 4.0;
constexpr double shortest = 4.0;  // explicit steps
constexpr double growth = 1.5;    // from one to the next, at most

}  // namespace

AdaptiveSteps::AdaptiveSteps(double tolerance, double explicit_step, double worth)
    : tolerance_(tolerance),
      allowed_(part_of_a_step * tolerance),
      explicit_step_(explicit_step),
      worth_(worth) {}

double AdaptiveSteps::share() const {
  return std::min(0.5, share_at_1e_4 * std::cbrt(tolerance_ / 1e-4));
}

int AdaptiveSteps::stages(double size) const { return ChebyshevStages::needed(size * stage_rate_); }

double AdaptiveSteps::cost_of(SteppingKind kind, double size) const {
  switch (kind) {
    case SteppingKind::explicit_euler:
      return std::max(1.0, size / explicit_step_);
    case SteppingKind::stages:
      return stage_rate_ > 0.0 && stages(std::min(size, 1e6 * explicit_step_)) <= most_stages
                 ? cost_of_stage * stages(size)
                 : std::numeric_limits<double>::infinity();
    default:
      return worth_;
  }
}

double AdaptiveSteps::least_size() const {
  return kind_ == SteppingKind::stages || (stage_rate_ > 0.0 && !are_long())
             ? std::min(longest_, shortest * explicit_step_)
             : 0.0;
}

SteppingKind AdaptiveSteps::cheapest(double size) const {
  const SteppingKind best =
      cost_of(SteppingKind::stages, size) < cost_of(SteppingKind::implicit, size)
          ? SteppingKind::stages
          : SteppingKind::implicit;
  const double price = best == SteppingKind::stages ? price_of_stages : 1.0;
  return price * cost_of(best, size) < cost_of(SteppingKind::explicit_euler, size)
             ? best
             : SteppingKind::explicit_euler;
}

double AdaptiveSteps::first_size(double time, double since) const {
  constexpr double begun = 12.0;  // explicit steps since: short ones that have just begun
  const double size = std::min(longest_, share() * (time - since));
  return time - since < begun * explicit_step_ ? size : std::max(least_size(), size);
}

bool AdaptiveSteps::is_worth(double size) const {
  return cost_of(kind_, size) <= 2.5 * size / explicit_step_;
}

bool AdaptiveSteps::choose(double time, double last_jump, double next_entry) {
  if (are_long()) {
    constexpr double clearly = 0.8;
    const double size = std::min(size_, next_entry - time);
    const SteppingKind best = cheapest(size);
    const bool is_better = best != kind_ && best != SteppingKind::explicit_euler &&
                           cost_of(best, size) < clearly * cost_of(kind_, size);
    if (last_jump <= since_ && is_better) {
      kind_ = best;
      return true;
    }
    if (last_jump > since_ || !is_worth(size)) {
      give_up(time);
      since_ = std::max(last_jump, since_);
      return true;
    }
    return false;
  }
  since_ = std::max(since_, last_jump);
  const double size = first_size(time, since_);
  const SteppingKind best = cheapest(std::min(size, next_entry - time));
  if (best == SteppingKind::explicit_euler) {
    return false;
  }
  kind_ = best;
  size_ = size;
  if (const double slowly = growth * explicit_step_; is_worth(slowly)) {
    size_ = std::min(size, slowly);
  }
  return true;
}

bool AdaptiveSteps::accepts(double size, double error) const {
  const bool is_least = size <= least_size() * (1.0 + 1e-6);
  return error <= 2.5 * allowed_ || (is_least && std::isfinite(error));
}

double AdaptiveSteps::shorter(double size, double error) const {
  const double wanted = size * std::clamp(0.9 * std::cbrt(allowed_ / error), 0.1, 0.7);
  return size > least_size() ? std::max(least_size(), wanted) : wanted;
}

void AdaptiveSteps::follow(double size, double error) {
  constexpr double caution = 0.9, worth_a_new_factor = 1.5;
  const double most = kind_ == SteppingKind::stages ? growth : 2.0;
  if (error < 0.0) {
    size_ = std::min({std::max(size, least_size()), most * size, longest_});
    return;
  }
  const double factor = error > 0.0 ? std::min(most, caution * std::cbrt(allowed_ / error)) : most;
  const double least = std::min(least_size(), most * size);
  const double wanted = std::max(least, std::min(longest_, size * factor));
  const bool shortened = size < (1.0 - 1e-6) * size_;  // to end at a frame or an entry
  if (shortened && factor == most && wanted < size_) {
    return;
  }
  if (kind_ == SteppingKind::stages || wanted < size_ || wanted > worth_a_new_factor * size_) {
    size_ = wanted;
  }
}

void AdaptiveSteps::give_up(double time) {
  kind_ = SteppingKind::explicit_euler;
  since_ = time;
}

void AdaptiveSteps::count(double time, double end, double last_jump, StepsAhead& all) const {
  constexpr double bunch = 64.0, waits = 0.05;  // of explicit steps looked at together
  constexpr int looks = 10'000;                 // the rest is as what was looked at last
  const double since = std::max(since_, last_jump);
  double size = are_long() && last_jump <= since_ ? size_ : 0.0;
  double now = time;
  for (int look = 0; now < end - 1e-12 * std::abs(end); ++look) {
    size = std::max(size, first_size(now, since));
    const double next = std::min({size, longest_, end - now});
    const SteppingKind kind = cheapest(next);
    const bool is_long = kind != SteppingKind::explicit_euler;
    const double span =
        is_long ? next
                : std::min(end - now, std::max(bunch * explicit_step_, waits * (now - since)));
    const double times = look < looks ? 1.0 : (end - now) / span;
    const double number = times * (is_long ? 1.0 : std::ceil(span / explicit_step_));
    all.number += number;
    all.cost += number * (is_long ? cost_of(kind, next) : 1.0);
    now += times * span;
  }
}

std::string AdaptiveSteps::reason() const {
  switch (kind_) {
    case SteppingKind::stages:
      return message("explicit heat in ", stages(size_), " stages: error of a step up to ",
                     allowed_, " of the span of temperatures");
    case SteppingKind::implicit:
      return message("implicit heat: error of a step up to ", allowed_,
                     " of the span of temperatures");
    default:
      return message("explicit heat, cheaper than implicit steps shorter than ",
                     worth_ * explicit_step_, " s");
  }
}

void AdaptiveSteps::save(Archive& archive) const {
  archive.write("heat/adaptive/kind", static_cast<Index>(kind_));
  archive.write("heat/adaptive/size", size_);
  archive.write("heat/adaptive/since", since_);
  archive.write("heat/adaptive/stage_rate", stage_rate_);
}

void AdaptiveSteps::load(const Archive& archive) {
  kind_ = static_cast<SteppingKind>(archive.read_index("heat/adaptive/kind"));
  size_ = archive.read_number("heat/adaptive/size");
  since_ = archive.read_number("heat/adaptive/since");
  stage_rate_ = archive.read_number("heat/adaptive/stage_rate");
}

}  // namespace lapilli
