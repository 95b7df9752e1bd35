#pragma once

#include <map>
#include <span>
#include <vector>

#include "lapilli/core/pair_entries.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"
#include "lapilli/mpm/surface/cut_shape.hpp"

namespace lapilli {

/// By body, as messages call it: by its number where it has no name.
std::vector<std::string> names_of(const std::vector<HeatBody>& bodies);

/// The bodies that touch with a thermal resistance.
PairEntries resisting_pairs(const std::vector<HeatBody>& bodies,
                            const std::vector<HeatContact>& contacts);

/// The problem with linear functions in place of GIMP ones where a material melts or two
/// conductivities meet. Smooth functions cannot follow the kinks of the temperature there: they
/// conduct 5 % too much across a ratio of 10 at twenty cells, linear ones .2 %.
template <int Dim>
HeatProblem<Dim> with_kinks(HeatProblem<Dim> problem);

/// A body cut by the grid, and its surface divided among the laws.
template <int Dim>
struct CutBody {
  std::vector<CellCut<Dim>> cells;
  std::vector<std::vector<SurfacePiece<Dim>>> pieces;               // by law
  std::vector<std::size_t> touching;                                // without resistance
  std::map<std::size_t, std::vector<SurfacePiece<Dim>>> resisting;  // by other body
  /// Where it touches others without resistance, by node of the cell: integral of n n^T, m^(dim-1).
  std::map<Index, Mat<Dim>> interface;
};

/// Cut body number `body` of the checked `shapes`; its free surface is entered in `found`.
template <int Dim>
CutBody<Dim> cut_body(const HeatProblem<Dim>& problem, std::span<const Shape> shapes,
                      std::size_t body, const PairEntries& resisting, SurfaceFound& found);

}  // namespace lapilli
