#pragma once

#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/materials/stiffness.hpp"
#include "lapilli/mpm/quasi_static/mean_dilatation.hpp"
#include "lapilli/mpm/quasi_static/point_weights.hpp"
#include "lapilli/mpm/quasi_static/surface.hpp"

namespace lapilli {

/// Which cells hold material, and the elastic moduli in each, averaged over the points that touch
/// it. A cell that only the domain of a point reaches is occupied too.
template <int Dim>
struct CellState {
  std::vector<char> occupied;  // one a cell
  std::vector<double> lame;    // Pa
  std::vector<double> shear;   // Pa
  std::vector<double> youngs;  // Pa
  MeanDilatation<Dim> mean;    // of nearly incompressible material; empty until built

  /// `volume` of each point, m^Dim; `body` of each, an index into `materials`.
  CellState(const Grid<Dim>& grid, std::span<const double> volume, std::span<const Index> body,
            const PointWeights<Dim>& weights, std::span<const LinearElastic> materials);
};

/// Marks the cells in which a wall may hold material: occupied ones and their neighbours.
template <int Dim>
std::vector<char> cells_near_material(const Grid<Dim>& grid, const CellState<Dim>& state);

/// The cell three quarters of a cell further in than a facet.
template <int Dim>
Index inner_cell(const Grid<Dim>& grid, const Facet<Dim>& facet);

/// Keep the facets that hold material: in an occupied cell, or (`hold_empty_cells`) in an empty one
/// with material three quarters of a cell further in, whose moduli it takes.
template <int Dim>
std::vector<Facet<Dim>> facets_at_material(const Grid<Dim>& grid, CellState<Dim>& state,
                                           std::vector<Facet<Dim>> facets, bool hold_empty_cells);

/// The pairs of neighbouring cells, cut by a facet or at the edge of the material, whose common
/// face ghost stabilisation acts on; `boxes` along each axis.
template <int Dim>
std::array<std::vector<CellBox<Dim>>, Dim> ghost_pairs(const Grid<Dim>& grid,
                                                       const CellState<Dim>& state,
                                                       std::span<const Facet<Dim>> facets);

}  // namespace lapilli
