#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lapilli/mpm/quasi_static/point_weights.hpp"
#include "lapilli/mpm/quasi_static/solid_state.hpp"

namespace lapilli {

/// Of each cell the share of its elastic stiffness that is left over all its points have strained
/// once they strain by `increment(point)` more; 1 without points. `volume` and `body` one a point.
template <int Dim>
std::vector<double> stiffness_left(const Grid<Dim>& grid, const PointWeights<Dim>& weights,
                                   std::span<const double> volume, std::span<const Index> body,
                                   const SolidState& solids,
                                   const std::function<SymmetricTensor(Index)>& increment);

}  // namespace lapilli
