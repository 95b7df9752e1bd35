#include "lapilli/materials/von_mises.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/materials/slope_of_return.hpp"

namespace lapilli {

void check(const VonMises& material) {
  check(material.elastic);
  const std::vector<double>& stress = material.yield_stress;
  const std::vector<double>& strain = material.plastic_strain;
  require(!stress.empty(), "von Mises: yield_stress must hold at least one number (Pa)");
  require(strain.size() == stress.size() || (strain.empty() && stress.size() == 1),
          "von Mises: plastic_strain must hold as many numbers as yield_stress, ", stress.size(),
          ", got ", strain.size());
  for (std::size_t k = 0; k < stress.size(); ++k) {
    require(std::isfinite(stress[k]) && stress[k] > 0.0,
            "von Mises: yield_stress must be positive (Pa), got ", stress[k]);
    require(k == 0 || stress[k] >= stress[k - 1],
            "von Mises: yield_stress must not fall (softening is not modelled), got ", stress[k],
            " after ", stress[k - 1], " Pa");
  }
  require(strain.empty() || strain[0] == 0.0, "von Mises: plastic_strain must begin at 0, got ",
          strain.empty() ? 0.0 : strain[0]);
  for (std::size_t k = 1; k < strain.size(); ++k) {
    require(std::isfinite(strain[k]) && strain[k] > strain[k - 1],
            "von Mises: plastic_strain must rise, got ", strain[k], " after ", strain[k - 1]);
  }
}

VonMisesLaw::VonMisesLaw(const VonMises& material)
    : three_shear(3.0 * material.elastic.shear_modulus()) {
  check(material);
  const std::vector<double>& stress = material.yield_stress;
  const std::vector<double>& strain = material.plastic_strain;
  for (std::size_t k = 0; k < stress.size(); ++k) {
    const double rise =
        k + 1 < stress.size() ? (stress[k + 1] - stress[k]) / (strain[k + 1] - strain[k]) : 0.0;
    lines.push_back({strain.empty() ? 0.0 : strain[k], stress[k], rise});
  }
}

VonMisesLaw::Line<double> VonMisesLaw::line(double q, double p) const {
  auto at = lines.begin();
  while (at + 1 != lines.end() && p >= (at + 1)->from) {
    ++at;
  }
  // On while the end of a line is passed within this return.
  while (at + 1 != lines.end() && q - three_shear * ((at + 1)->from - p) > (at + 1)->start) {
    ++at;
  }
  return *at;
}

VonMisesLaw::Line<Double4> VonMisesLaw::line(Double4 q, Double4 p) const {
  if (lines.size() == 1) {
    return {all(lines[0].from), all(lines[0].start), all(lines[0].slope)};
  }
  Line<Double4> found{};
  for (int lane = 0; lane < 4; ++lane) {
    const Line<double> one = line(q[lane], p[lane]);
    found.from[lane] = one.from;
    found.start[lane] = one.start;
    found.slope[lane] = one.slope;
  }
  return found;
}

SymmetricTensor VonMisesLaw::stress_and_slope(const SymmetricTensor& trial, double* state,
                                              StressSlope& slope) const {
  return differentiate_return(*this, trial, state, slope);
}

}  // namespace lapilli
