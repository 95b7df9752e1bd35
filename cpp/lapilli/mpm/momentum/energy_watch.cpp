#include "lapilli/mpm/momentum/energy_watch.hpp"

#include <algorithm>

namespace lapilli {
namespace {

/// Share of the largest energy so far that may appear from nowhere.
constexpr double allowed = 0.01;

}  // namespace

bool EnergyWatch::add_step(double kinetic, double strain_work, double gained) {
  stored_ += strain_work;
  largest_ = std::max(largest_, kinetic + std::max(0.0, stored_));
  return !(gained > allowed * largest_);
}

}  // namespace lapilli
