#pragma once

#include "lapilli/core/value.hpp"

namespace lapilli {

/// Fill `values`, one a row, with the mean of a constant or table over a step, or a function in the
/// middle of it.
void evaluate_over(const Value& value, std::span<const Vec3> position,
                   std::span<const double> state, double from, double to, std::span<double> values);

/// Whether a table jumps in [from, to).
bool jumps_within(const Value& value, double from, double to);

}  // namespace lapilli
