#pragma once

#include <span>
#include <string>
#include <vector>

#include "lapilli/mpm/quasi_static/equilibrium.hpp"

namespace lapilli {

/// Throw RunError when a part of the material that hangs together is free to move as a rigid body:
/// says where it is and which motion the walls leave. `kinds` by wall.
template <int Dim>
void require_held(const Grid<Dim>& grid, const Points& points, const PointWeights<Dim>& weights,
                  std::span<const Facet<Dim>> facets, std::span<const HeldMotion> kinds);

/// Throw RunError when two walls lie on the same place and prescribe different motions there:
/// names both. `motions` are the increments at the points of each facet.
template <int Dim>
void require_agreeing(const Grid<Dim>& grid, std::span<const Facet<Dim>> facets,
                      const std::vector<std::vector<Vec<Dim>>>& motions,
                      std::span<const HeldMotion> kinds, std::span<const std::string> names);

}  // namespace lapilli
