#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/balance.hpp"
#include "lapilli/mpm/heat/boundary_conditions.hpp"

namespace lapilli {

/// Enter what a body stores, sum C T (J), the scale of its balance, all of its capacity over the
/// range of its temperatures, and the bar. Entries without capacity do not count.
void add_stored_heat(std::span<const double> capacity, std::span<const double> temperature,
                     Balance& balance);

/// Area of the surface and the share of negative areas in it; nothing where there are no laws.
template <int Dim>
std::vector<std::pair<std::string, double>> surface_diagnostics(const BoundaryConditions<Dim>& laws,
                                                                double negative_share);

}  // namespace lapilli
