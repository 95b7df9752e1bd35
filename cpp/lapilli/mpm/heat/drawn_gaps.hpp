#pragma once

#include <span>
#include <string>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/surface/cube_parts.hpp"

namespace lapilli {

/// Enter in `found` the bodies that a body touches.
void enter_touching(std::span<const std::size_t> others, SurfaceFound& found);

/// Enter in `found` the bodies that a free piece of the surface of body number `body` faces less
/// than a twentieth of a cell away. `cell` in m.
template <int Dim>
void enter_facing(const SurfacePiece<Dim>& piece, std::span<const Shape> shapes, std::size_t body,
                  double cell, SurfaceFound& found);

/// ": 2e-05 m (0.02 cells) lie between them", the gap between two bodies, given by name, that were
/// found to face each other so near; empty where there is none. `found` by body.
std::string gap_between(const std::vector<std::string>& pair, std::span<const SurfaceFound> found,
                        const std::vector<HeatBody>& bodies, double cell);

/// What to warn of where two bodies lie apart by more than what counts as contact and by less than
/// what a drawing means. One sentence a pair.
std::vector<Note> drawn_gaps(std::span<const SurfaceFound> found,
                             const std::vector<HeatBody>& bodies, double cell, int dimension);

}  // namespace lapilli
