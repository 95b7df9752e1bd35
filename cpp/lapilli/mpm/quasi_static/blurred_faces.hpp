#pragma once

#include <vector>

#include "lapilli/geometry/grid.hpp"
#include "lapilli/mpm/quasi_static/solid_state.hpp"

namespace lapilli {

/// A body that strains too little where it shares cells with a stiffer one.
struct BlurredFace {
  Index body = 0;
  double missing = 0.0;  // m, of the displacement across the face
};

/// The body that lacks most displacement because a cell has one strain for all that lies in it:
/// beside a stiffer body it strains like that one. How much too little, its strain in the next
/// cells that it has for itself says. `missing` is 0 where no cell is shared.
template <int Dim>
BlurredFace worst_blurred_face(const Grid<Dim>& grid, const Points& points,
                               const SolidState& solids);

}  // namespace lapilli
