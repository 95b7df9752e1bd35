#include "lapilli/materials/tabulated_mohr_coulomb.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lapilli/core/require.hpp"
#include "lapilli/materials/slope_of_return.hpp"

namespace lapilli {
namespace {

/// The value of a list of one number or of one a plastic strain.
double at(const std::vector<double>& list, std::size_t k) {
  return list.size() == 1 ? list[0] : list[k];
}

void check_length(const TabulatedMohrCoulomb& material, const std::vector<double>& list,
                  const char* name) {
  require(list.size() == 1 || list.size() == material.plastic_strain.size(),
          "tabulated Mohr-Coulomb: ", name, " must hold one number or as many as plastic_strain, ",
          material.plastic_strain.size(), ", got ", list.size());
}

}  // namespace

void check(const TabulatedMohrCoulomb& material) {
  const std::vector<double>& strain = material.plastic_strain;
  require(strain.size() >= 2 && strain[0] == 0.0,
          "tabulated Mohr-Coulomb: plastic_strain must hold two numbers or more and begin at 0");
  for (std::size_t k = 1; k < strain.size(); ++k) {
    require(std::isfinite(strain[k]) && strain[k] > strain[k - 1],
            "tabulated Mohr-Coulomb: plastic_strain must rise, got ", strain[k], " after ",
            strain[k - 1]);
  }
  check_length(material, material.friction_angle, "friction_angle");
  check_length(material, material.dilatancy_angle, "dilatancy_angle");
  check_length(material, material.cohesion, "cohesion");
  for (std::size_t k = 0; k < strain.size(); ++k) {
    check(MohrCoulomb{material.elastic, at(material.friction_angle, k),
                      at(material.dilatancy_angle, k), at(material.cohesion, k),
                      material.tension_cutoff});
  }
}

TabulatedMohrCoulombLaw::TabulatedMohrCoulombLaw(const TabulatedMohrCoulomb& material)
    : strains(material.plastic_strain),
      tension_cutoff(material.tension_cutoff),
      poissons_ratio(material.elastic.poissons_ratio),
      twice_shear(2.0 * material.elastic.shear_modulus()) {
  check(material);
  const double degree = std::numbers::pi / 180.0;
  for (std::size_t k = 0; k < strains.size(); ++k) {
    const double sine = std::sin(at(material.friction_angle, k) * degree);
    const double cosine = std::cos(at(material.friction_angle, k) * degree);
    entries.push_back({sine, cosine * cosine / (1.0 + sine),
                       2.0 * at(material.cohesion, k) * cosine,
                       std::sin(at(material.dilatancy_angle, k) * degree)});
  }
}

TabulatedMohrCoulombLaw::Entry TabulatedMohrCoulombLaw::entry(double plastic_strain) const {
  if (plastic_strain >= strains.back()) {
    return entries.back();
  }
  std::size_t k = 1;
  while (plastic_strain >= strains[k]) {
    ++k;
  }
  const double share = (plastic_strain - strains[k - 1]) / (strains[k] - strains[k - 1]);
  Entry between{};
  for (std::size_t i = 0; i < between.size(); ++i) {
    between[i] = (1.0 - share) * entries[k - 1][i] + share * entries[k][i];
  }
  return between;
}

MohrCoulombNumbers<double> TabulatedMohrCoulombLaw::numbers(double plastic_strain) const {
  const Entry e = entry(plastic_strain);
  return {e[0], e[1], e[2], e[3], tension_cutoff, poissons_ratio};
}

MohrCoulombNumbers<Double4> TabulatedMohrCoulombLaw::numbers(Double4 plastic_strain) const {
  Double4 of[4];
  for (int lane = 0; lane < 4; ++lane) {
    const Entry e = entry(plastic_strain[lane]);
    for (std::size_t i = 0; i < e.size(); ++i) {
      of[i][lane] = e[i];
    }
  }
  return {of[0], of[1], of[2], of[3], tension_cutoff, poissons_ratio};
}

SymmetricTensor TabulatedMohrCoulombLaw::stress_and_slope(const SymmetricTensor& trial,
                                                          double* state, StressSlope& slope) const {
  const MohrCoulombNumbers<double> now = numbers(state[0]);
  const SymmetricTensor reached = differentiate_principal(
      [&now](const auto& t1, const auto& t2, const auto& t3) {
        return return_sorted<double>(now, t1, t2, t3);
      },
      trial, slope);
  return_point(*this, trial, state);  // for the state
  return reached;
}

}  // namespace lapilli
