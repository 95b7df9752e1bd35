#pragma once

#include <algorithm>
#include <cmath>

namespace lapilli {

/// Pressure of a weakly compressible fluid, p = rho0 c^2 / n ((rho/rho0)^n - 1) (Eq. 11).
struct EquationOfState {
  double density = 1.0;      // kg/m^3, rho0
  double sound_speed = 1.0;  // m/s, c
  double exponent = 7.0;     // n

  double operator()(double now) const {
    const double ratio = now / density;
    const double scale = density * sound_speed * sound_speed / exponent;
    if (exponent == 7.0) {
      const double cubed = ratio * ratio * ratio;
      return scale * (cubed * cubed * ratio - 1.0);
    }
    return scale * (std::pow(ratio, exponent) - 1.0);
  }
  /// The density that gives a pressure; that of a hundredth of the first below it.
  double density_at(double pressure) const {
    const double scale = density * sound_speed * sound_speed / exponent;
    return density * std::pow(std::max(1e-2, 1.0 + pressure / scale), 1.0 / exponent);
  }
};

}  // namespace lapilli
