#pragma once

#include <span>

#include "lapilli/mpm/heat/heat_part.hpp"

namespace lapilli {

/// Source heat of a part by place over [begin, begin + size] (J), handed to the nodes that lead and
/// added to `heat`; returns the sum. `temperature` by place.
template <int Dim>
double source_heat(const HeatPart<Dim>& part, const std::vector<HeatBody>& bodies,
                   std::span<const double> temperature, double begin, double size,
                   std::span<double> heat);

}  // namespace lapilli
