#pragma once

#include <string>
#include <vector>

#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/quasi_static/cell_state.hpp"
#include "lapilli/mpm/quasi_static/settings.hpp"

namespace lapilli {

/// Distance to the nearest of the bodies, m; infinite without any.
double distance_to(const std::vector<Shape>& bodies, const Vec3& at);

/// Throw RunError where most of a surface under pressure has the bodies on the side that the
/// pressure comes from: it would pull. `what` names the surface.
template <int Dim>
void require_pushes(const std::vector<Shape>& bodies, const std::vector<Facet<Dim>>& facets,
                    double cell_size, const SurfaceSettings& surface, const std::string& what);

/// Facets off all bodies, in cells without material, take the functions of the cell that the bodies
/// end in, continued to them.
template <int Dim>
void reach_from_bodies(const Grid<Dim>& grid, const CellState<Dim>& state,
                       const std::vector<Shape>& bodies, std::vector<Facet<Dim>>& facets);

/// Largest distance of the facets of a wall from all bodies (m) where most of it lies off them; 0
/// where it does not.
template <int Dim>
double distance_off(const std::vector<Shape>& bodies, const std::vector<Facet<Dim>>& facets,
                    int wall, double cell_size);

}  // namespace lapilli
