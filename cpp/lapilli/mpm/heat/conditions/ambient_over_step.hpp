#pragma once

#include "lapilli/core/value.hpp"

namespace lapilli {

/// The ambient temperature that counts over a step: the mean weighted by the coefficient of the
/// law, of the `power`-th power above absolute zero at `zero` (1 of convection, 4 of radiation).
/// `ambient` is a constant or a table; a coefficient that is a function counts as constant.
double ambient_over(const Value& coefficient, const Value& ambient, int power, double zero,
                    double begin, double end);

}  // namespace lapilli
