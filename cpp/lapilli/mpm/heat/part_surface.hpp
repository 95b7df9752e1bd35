#pragma once

#include "lapilli/mpm/heat/cut_bodies.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"

namespace lapilli {

/// Connect the surface of a part to its nodes: fills `surface`, `unknown_place` and `nodal` from
/// the pieces of the part's bodies. Followers must be known.
template <int Dim>
void connect_surface(const HeatProblem<Dim>& problem, const std::vector<CutBody<Dim>>& cut,
                     HeatPart<Dim>& part);

/// Give all nodes of a part their capacity and temperature at the start, and their sources; from
/// `volume` by body of the part and node of the grid (m^Dim).
template <int Dim>
void store_heat(const HeatProblem<Dim>& problem, const std::vector<std::vector<double>>& volume,
                HeatPart<Dim>& part);

}  // namespace lapilli
