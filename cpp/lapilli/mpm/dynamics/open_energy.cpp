#include "lapilli/mpm/dynamics/open_energy.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr double open_share = 0.05;  // of the largest turnover
constexpr double largest_strain = 0.05;
constexpr double gained_share = 0.01;  // of the largest energy; a run stops at five times that

/// J: plastic flow takes energy; what it gives, as a function that is stiffer than its elastic
/// constants does while it is strained, nobody put in.
double given_by_plastic_work(const Balance& energy) {
  const auto plastic = std::ranges::find(energy.entries, "plastic", &Balance::Entry::name);
  return plastic == energy.entries.end() ? 0.0 : std::max(0.0, plastic->in);
}

}  // namespace

void OpenEnergy::look(const Balance& energy, double largest, double strain, double gained) {
  gap_ = std::max({gap_, std::abs(energy.gap()), given_by_plastic_work(energy)});
  reference_ = std::max({reference_, energy.turnover(), energy.scale, largest});
  strain_ = std::max(strain_, strain);
  gained_ = std::max(gained_, gained);
  largest_ = std::max(largest_, largest);
}

std::vector<Note> OpenEnergy::warnings() const {
  std::vector<Note> all;
  if (gap_ > open_share * reference_) {
    all.push_back(note("dynamics.open-energy", "the balance of energy does not close: up to ", gap_,
                       " J, ", 100.0 * gap_ / reference_,
                       " % of what was stored or turned over, are unaccounted for"));
  }
  if (gained_ > gained_share * largest_) {
    all.push_back(note("dynamics.gained-energy",
                       "the motion gains energy that nothing put in, up to ", gained_, " J, ",
                       100.0 * gained_ / largest_,
                       " % of its largest: dynamics.transfer blended_apic with stress_update "
                       "musl and gimp functions, or a smaller dynamics.courant, may hold it"));
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
  gained_ = numbers.at(4);
  largest_ = numbers.at(5);
}

}  // namespace lapilli
