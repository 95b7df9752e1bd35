#include "lapilli/materials/modified_cam_clay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/materials/slope_of_return.hpp"

namespace lapilli {
namespace {

constexpr double loosest = -20.0;  // ln(pc / pc0)
constexpr double densest = 600.0;  // beyond, exp overflows
constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
constexpr int most_steps = 200;  // each at least halves a bracket

/// The pressure for a multiplier: the root of p + s (2 p - pc(p)) - trial, which rises with p. Its
/// slope falls with p: from the left, Newton's method comes up to the root without passing it.
double pressure_at(const ModifiedCamClayLaw& law, double s, double trial, double compaction) {
  const double bound = law.preconsolidation(compaction);
  double p = trial;
  if (2.0 * trial > bound) {
    // The root lies where pc has grown, to no more than twice the pressure.
    const double most = law.softness * std::log(2.0 * trial / law.start) - compaction;
    p = std::max((trial + s * bound) / (1.0 + 2.0 * s), trial - law.bulk * most);
  }
  for (int step = 0; step < most_steps; ++step) {
    const double whole = compaction + (trial - p) / law.bulk;
    const double miss = p + s * (2.0 * p - law.preconsolidation(whole)) - trial;
    const double change = -miss / (1.0 + s * (2.0 + law.hardening(whole) / law.bulk));
    p += change;
    if (std::abs(change) <= rounding * std::max(std::abs(p), std::abs(trial))) {
      break;
    }
  }
  return p;
}

}  // namespace

void check(const ModifiedCamClay& material) {
  check(material.elastic);
  const auto positive = [](double value, const char* name, const char* unit) {
    require(std::isfinite(value) && value > 0.0, "modified Cam-clay: ", name, " must be positive",
            unit, ", got ", value);
  };
  positive(material.critical_state_slope, "critical_state_slope", "");
  positive(material.plastic_compressibility, "plastic_compressibility", "");
  positive(material.preconsolidation_pressure, "preconsolidation_pressure", " (Pa)");
}

ModifiedCamClayLaw::ModifiedCamClayLaw(const ModifiedCamClay& material)
    : slope_square(material.critical_state_slope * material.critical_state_slope),
      bulk(material.elastic.bulk_modulus()),
      shear_loss(6.0 * material.elastic.shear_modulus() / (bulk * slope_square)),
      softness(material.plastic_compressibility),
      start(material.preconsolidation_pressure) {
  check(material);
}

double ModifiedCamClayLaw::preconsolidation(double compaction) const {
  return start * std::exp(std::clamp(compaction / softness, loosest, densest));
}

double ModifiedCamClayLaw::hardening(double compaction) const {
  const double exponent = compaction / softness;
  return exponent > loosest && exponent < densest ? preconsolidation(compaction) / softness : 0.0;
}

ModifiedCamClayLaw::Reached<double> ModifiedCamClayLaw::reach(double pressure, double shear,
                                                              double compaction) const {
  const auto yield = [&](double s, double p) {
    const double q = shear / (1.0 + shear_loss * s);
    const double bound = preconsolidation(compaction + (pressure - p) / bulk);
    return q * q / slope_square + p * (p - bound);
  };
  if (!(yield(0.0, pressure) > 0.0)) {
    return {pressure, 1.0, 0.0};
  }
  // Without bounds on the multiplier the state is critical and inside the ellipse.
  double low = 0.0, high = 1.0;
  while (yield(high, pressure_at(*this, high, pressure, compaction)) > 0.0 && high < 1e300) {
    low = high;
    high *= 4.0;
  }
  double s = low > 0.0 ? std::sqrt(low * high) : 0.5 * high, p = pressure;
  for (int step = 0; step < most_steps; ++step) {
    p = pressure_at(*this, s, pressure, compaction);
    const double miss = yield(s, p);
    (miss > 0.0 ? low : high) = s;
    const double whole = compaction + (pressure - p) / bulk;
    const double pc = preconsolidation(whole), per_pressure = -hardening(whole) / bulk;
    const double share = 1.0 / (1.0 + shear_loss * s), q = share * shear;
    const double p_slope = -(2.0 * p - pc) / (1.0 + s * (2.0 - per_pressure));
    const double slope = -2.0 * shear_loss * share * q * q / slope_square +
                         (2.0 * p - pc - p * per_pressure) * p_slope;
    const double newton = s - miss / slope;
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - s) <= rounding * s) {
      break;
    }
    s = next;
  }
  return {p, 1.0 / (1.0 + shear_loss * s), s};
}

ModifiedCamClayLaw::Reached<Double4> ModifiedCamClayLaw::reach(Double4 pressure, Double4 shear,
                                                               Double4 compaction) const {
  Reached<Double4> found{};
  for (int lane = 0; lane < 4; ++lane) {
    const Reached<double> one = reach(pressure[lane], shear[lane], compaction[lane]);
    found.pressure[lane] = one.pressure;
    found.share[lane] = one.share;
    found.multiplier[lane] = one.multiplier;
  }
  return found;
}

SymmetricTensor ModifiedCamClayLaw::stress_and_slope(const SymmetricTensor& trial, double* state,
                                                     StressSlope& slope) const {
  return differentiate_return(*this, trial, state, slope);
}

}  // namespace lapilli
