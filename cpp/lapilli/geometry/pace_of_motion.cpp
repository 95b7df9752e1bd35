#include "lapilli/geometry/pace_of_motion.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

/// To three digits.
double rounded(double number) {
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 2.0);
  return unit * std::round(number / unit);
}

}  // namespace

StepLimit PaceOfMotion::step_limit() const {
  StepLimit limit;
  limit.automatic = longest_;
  limit.reason = "prescribed motion past conditions that stay in space";
  return limit;
}

StepReport PaceOfMotion::advance(const Step& step) {
  taken_ = std::max(taken_, step.size);
  return {step.size, 0, 0.0};
}

std::vector<Note> PaceOfMotion::warnings() const {
  if (taken_ <= longest_ * (1.0 + 1e-9)) {
    return {};
  }
  return {note("motion.long-step", "a step of ", taken_, " s is ", rounded(taken_ / longest_),
               " times what follows the motion past conditions that stay in space (a quarter of "
               "a cell of path of the fastest point, a fortieth of a turn): leave time.step "
               "out, or give at most ",
               rounded(longest_), " s")};
}

}  // namespace lapilli
