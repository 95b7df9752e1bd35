#pragma once

#include <span>
#include <vector>

#include "lapilli/mpm/heat/heat_part.hpp"

namespace lapilli {

/// Source heat of a part by place over [begin, begin + size] (J), handed to the nodes that lead and
/// added to `heat`; returns the sum. `temperature` by place.
template <int Dim>
double source_heat(const HeatPart<Dim>& part, const std::vector<HeatBody>& bodies,
                   std::span<const double> temperature, double begin, double size,
                   std::span<double> heat);

/// What sources give the nodes that lead, by place.
struct SourceRates {
  std::vector<double> power;  // W
  std::vector<double> fall;   // W/K, less for every kelvin; empty where no source is a function
};

/// Tables by their means over the step, functions at its middle.
template <int Dim>
SourceRates source_rates(const HeatPart<Dim>& part, const std::vector<HeatBody>& bodies,
                         std::span<const double> temperature, double begin, double end);

}  // namespace lapilli
