#include "lapilli/mpm/dynamics/energy_watch.hpp"

#include <algorithm>

namespace lapilli {
namespace {

/// Shares of the largest energy so far that may appear from nowhere: for good, and for a while. The
/// affine part of a point grows and shrinks as it crosses its cell, which tells in the first steps
/// of a fall, while there is little else.
constexpr double allowed = 0.05, at_once = 0.5;
constexpr double patience = 1000;  // steps

}  // namespace

bool EnergyWatch::add_step(double kinetic, double strain_work, double gained, double rounding) {
  stored_ += strain_work;
  largest_ = std::max(largest_, kinetic + std::max(0.0, stored_));
  steps_above_ = gained > allowed * largest_ + rounding ? steps_above_ + 1.0 : 0.0;
  return steps_above_ < patience && !(gained > at_once * largest_ + rounding);
}

}  // namespace lapilli
