#pragma once

#include <vector>

#include "lapilli/mpm/heat/heat_settings.hpp"

namespace lapilli {

/// The values a condition is made of.
std::vector<const Value*> values_of(const HeatBoundary& condition);
bool has_function(const HeatBoundary& condition);

}  // namespace lapilli
