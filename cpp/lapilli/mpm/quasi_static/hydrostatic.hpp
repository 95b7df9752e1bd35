#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/quasi_static/loaded_surface.hpp"

namespace lapilli {

/// A pressure that balances an even body force, rise . x - level.
template <int Dim>
struct HydrostaticPressure {
  Vec<Dim> rise = Vec<Dim>::Zero();  // Pa/m: the body force
  double level = 0.0;                // Pa

  double at(const Vec<Dim>& place) const { return rise.dot(place) - level; }
};

/// The surface of the bodies whose entry in `averaged` is set, at rest. Nothing where the shapes
/// are not known or do not bound the `volume` (m^Dim, by body) of their points, as when bodies
/// overlap or leave the grid.
template <int Dim>
std::optional<LoadedSurface<Dim>> skin_of(const Grid<Dim>& grid, const std::vector<Shape>& shapes,
                                          std::span<const char> averaged,
                                          std::span<const double> volume);

}  // namespace lapilli
