#pragma once

#include <algorithm>
#include <cmath>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {

/// What a source adds, K, to a rise that would be `rise` without it: it gives `heat` (J) over the
/// step at the temperature of its start, and `fall` (J/K) less for every kelvin. Exact for a source
/// that is linear in the temperature beside a steady rate (exponential Euler, Hochbruck & Ostermann
/// 2010); one that restores a temperature does not pass it, however strong it is.
inline double rise_by_source(double rise, double heat, double fall, double capacity) {
  const double grows = -fall / capacity;
  const double beyond = std::abs(grows) > 1e-6 ? std::expm1(grows) / grows - 1.0 : 0.5 * grows;
  return beyond * rise + (1.0 + beyond) * heat / capacity;
}

/// How fast sources that rise with the temperature heat themselves, which steps must follow.
class SelfHeating {
 public:
  void forget() { rate_ = 0.0; }
  /// A place of this capacity (J/K) whose source falls by `fall` (W/K) for every kelvin.
  void meet(double fall, double capacity) { rate_ = std::max(rate_, -fall / capacity); }

  double rate() const { return rate_; }  // 1/s
  void set_rate(double rate) { rate_ = rate; }

  /// Bound automatic steps to a tenth of the e-folding time.
  void bound(StepLimit& limit) const {
    if (rate_ > 0.0 && 0.1 / rate_ < limit.automatic) {
      limit.automatic = 0.1 / rate_;
      limit.reason = "a source that heats itself";
    }
  }
  /// Throws RunError where the step just taken was longer than the e-folding time.
  void require_followed(double step) const {
    if (rate_ * step > 1.0) {
      throw RunError(
          message("heat: a source rises with the temperature so fast that it heats itself "
                  "e-fold in ",
                  1.0 / rate_, " s, less than the step of ", step, " s; take smaller steps"));
    }
  }

 private:
  double rate_ = 0.0;
};

}  // namespace lapilli
