#include "lapilli/mpm/heat/adaptive_steps.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

// A step of this share of the time since the start has an error of a fifth of 1e-4 of what has
// changed, where temperatures go as roots of the time.
constexpr double share_at_1e_4 = 0.08;
constexpr double part_of_a_step = 0.2;  // of the tolerance

}  // namespace

AdaptiveSteps::AdaptiveSteps(double tolerance, double explicit_step, double worth)
    : tolerance_(tolerance),
      allowed_(part_of_a_step * tolerance),
      explicit_step_(explicit_step),
      worth_(worth) {}

bool AdaptiveSteps::choose(double time, double last_jump, double next_entry) {
  if (implicit_) {
    if (last_jump > since_ || !is_worth(std::min(size_, next_entry - time))) {
      give_up(time);
      since_ = std::max(last_jump, since_);
      return true;
    }
    return false;
  }
  since_ = std::max(since_, last_jump);
  const double share = share_at_1e_4 * std::cbrt(tolerance_ / 1e-4);
  const double size = std::min(longest_, std::min(0.5, share) * (time - since_));
  if (std::min(size, next_entry - time) < worth_ * explicit_step_) {
    return false;
  }
  implicit_ = true;
  size_ = size;
  return true;
}

double AdaptiveSteps::shorter(double size, double error) const {
  return size * std::clamp(0.9 * std::cbrt(allowed_ / error), 0.1, 0.7);
}

void AdaptiveSteps::follow(double size, double error) {
  constexpr double caution = 0.9, most = 2.0, worth_a_new_factor = 1.5;
  const double factor = error > 0.0 ? std::min(most, caution * std::cbrt(allowed_ / error)) : most;
  const double wanted = std::min(longest_, size * factor);
  const bool shortened = size < (1.0 - 1e-6) * size_;  // to end at a frame or an entry
  if (shortened && factor == most) {
    return;
  }
  if (wanted < size_ || wanted > worth_a_new_factor * size_) {
    size_ = wanted;
  }
}

void AdaptiveSteps::give_up(double time) {
  implicit_ = false;
  since_ = time;
}

std::string AdaptiveSteps::reason() const {
  return implicit_ ? message("implicit heat: error of a step up to ", allowed_,
                             " of the span of temperatures")
                   : message("explicit heat, cheaper than implicit steps shorter than ",
                             worth_ * explicit_step_, " s");
}

void AdaptiveSteps::save(Archive& archive) const {
  archive.write("heat/adaptive/implicit", Index{implicit_});
  archive.write("heat/adaptive/size", size_);
  archive.write("heat/adaptive/since", since_);
}

void AdaptiveSteps::load(const Archive& archive) {
  implicit_ = archive.read_index("heat/adaptive/implicit") != 0;
  size_ = archive.read_number("heat/adaptive/size");
  since_ = archive.read_number("heat/adaptive/since");
}

}  // namespace lapilli
