#include "lapilli/mpm/dynamics/open_energy.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr double open_share = 0.05;  // of the largest turnover
constexpr double largest_strain = 0.05;

}  // namespace

void OpenEnergy::look(const Balance& energy, double largest, double strain) {
  gap_ = std::max(gap_, std::abs(energy.gap()));
  reference_ = std::max({reference_, energy.turnover(), energy.scale, largest});
  strain_ = std::max(strain_, strain);
}

std::vector<Note> OpenEnergy::warnings() const {
  std::vector<Note> all;
  if (gap_ > open_share * reference_) {
    all.push_back(note("dynamics.open-energy", "the balance of energy does not close: up to ", gap_,
                       " J, ", 100.0 * gap_ / reference_,
                       " % of what was stored or turned over, are unaccounted for"));
  }
  if (strain_ > largest_strain) {
    all.push_back(note("dynamics.large-elastic-strain", "elastic strains reach ", 100.0 * strain_,
                       " %: stresses follow rates (a hypoelastic law), and the energy that they "
                       "store is known to some percents only beyond 5 %"));
  }
  return all;
}

void OpenEnergy::restore(const std::vector<double>& numbers) {
  gap_ = numbers.at(0);
  reference_ = numbers.at(1);
  strain_ = numbers.at(2);
  steps_ = static_cast<Index>(numbers.at(3));
}

}  // namespace lapilli
