#pragma once

#include <span>
#include <utility>
#include <vector>

#include "lapilli/mpm/heat/cut_bodies.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"

namespace lapilli {

/// Pieces of surface, by the body that has them.
template <int Dim>
using PiecesOfBodies = std::vector<std::pair<std::size_t, std::span<const SurfacePiece<Dim>>>>;

/// What acts on the surface of a part: by law, then by resisting contact (the pieces of its first
/// body, whichever is in the part).
template <int Dim>
std::vector<PiecesOfBodies<Dim>> pieces_of_part(const std::vector<CutBody<Dim>>& cut,
                                                std::span<const ResistingContact> contacts,
                                                const std::vector<std::size_t>& bodies);

/// Connect the surface of a part to its nodes: fills `surface`, `unknown_place` and `nodal` from
/// the pieces of the part. Followers must be known.
template <int Dim>
void connect_surface(const HeatProblem<Dim>& problem,
                     const std::vector<PiecesOfBodies<Dim>>& pieces, HeatPart<Dim>& part);

/// Give all nodes of a part their capacity and temperature at the start, and their sources; from
/// `volume` by body of the part and node of the grid (m^Dim).
template <int Dim>
void store_heat(const HeatProblem<Dim>& problem, const std::vector<std::vector<double>>& volume,
                HeatPart<Dim>& part);

}  // namespace lapilli
