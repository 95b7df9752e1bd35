#pragma once

#include <array>
#include <vector>

#include "lapilli/peridynamics/boundary_pieces.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// The surface of the fluid's region in flat pieces, box by box of the lattice that its points were
/// filled into.
struct FluidSurface {
  using BoxIndex = std::array<long, 3>;

  Vec3 lattice;  // m, a corner of the boxes
  double side;   // m
  int dimension;
  std::vector<Vec3> boxes;                         // m, lower corners
  std::vector<std::vector<BoundaryPiece>> pieces;  // by box

  BoxIndex box_of(const Vec3& at) const;
};

/// Of a region that is known, with the points where they are now.
FluidSurface find_fluid_surface(const WallSurface& walls);

/// Area that each wall shares with the fluid, m^(dimension - 1).
std::vector<double> shared_areas(const WallSurface& walls);

}  // namespace lapilli
