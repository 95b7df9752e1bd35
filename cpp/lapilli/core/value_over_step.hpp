#pragma once

#include "lapilli/core/value.hpp"

namespace lapilli {

/// Mean of a table over [from, to], exact: what a step of that length meets of it. Where two times
/// are equal the table jumps. Throws nothing; `to` may equal `from`.
double mean_over(const Table& table, double from, double to);

/// Mean over a step of a value that does not depend on place or state; 0 for a function.
double mean_over(const Value& value, double from, double to);

/// Fill `values`, one a row, with the mean of a constant or table over a step, or a function in the
/// middle of it.
void evaluate_over(const Value& value, std::span<const Vec3> position,
                   std::span<const double> state, double from, double to,
                   std::span<double> values);

/// Whether a table jumps in [from, to).
bool jumps_within(const Value& value, double from, double to);

}  // namespace lapilli
