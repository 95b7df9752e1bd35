#include "lapilli/mpm/momentum/energy_watch.hpp"

#include <algorithm>

namespace lapilli {
namespace {

/// Share of the largest energy so far that may appear from nowhere. Stable runs stay below a
/// hundredth but for their first steps, in which the affine part of a point may grow as it crosses
/// its cell.
constexpr double allowed = 0.1;

}  // namespace

bool EnergyWatch::add_step(double kinetic, double strain_work, double gained) {
  stored_ += strain_work;
  largest_ = std::max(largest_, kinetic + std::max(0.0, stored_));
  return !(gained > allowed * largest_);
}

}  // namespace lapilli
