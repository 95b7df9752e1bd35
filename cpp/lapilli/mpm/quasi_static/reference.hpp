#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/mpm/quasi_static/boundary.hpp"
#include "lapilli/mpm/quasi_static/cell_state.hpp"
#include "lapilli/mpm/quasi_static/hydrostatic.hpp"
#include "lapilli/mpm/quasi_static/support_ends.hpp"
#include "lapilli/mpm/quasi_static/support_terms.hpp"

namespace lapilli {

/// What stands until the grid is reset: where the points were then, and what follows from it. The
/// grid is reset as ever in the material point method, but not before a point has moved: moved
/// points no longer integrate cut cells exactly, and small displacements need not pay for that.
template <int Dim>
struct Reference {
  /// `gimp`: points have half-widths. `points` must outlive it.
  Reference(Points& points, bool gimp);

  /// Start anew where the points are now. `half_width` is that of now, null without GIMP.
  void start(const Points& points, const PointArray* half_width, double at);
  /// Weights, cells and facets of the positions it holds. Throws RunError as `Boundary::cut_walls`.
  /// `averaged`: bodies whose dilatation is averaged over cells.
  void locate(const Grid<Dim>& grid, const Points& points, std::span<const LinearElastic> materials,
              std::span<const char> averaged, const Boundary<Dim>& boundary);
  /// Farthest that a point is along an axis from where it was, once it moves by `moves` (may be
  /// empty), m.
  double farthest(const Points& points, const std::vector<Vec<Dim>>& moves = {}) const;

  void save(Archive& archive) const;
  /// Everything but what `locate` finds.
  void load(const Archive& archive);

  void find_skin(const Grid<Dim>& grid);

  double time = 0.0;
  PointArray position;                     // m, rows x Dim
  PointArray volume;                       // m^Dim
  std::unique_ptr<PointArray> half_width;  // m, rows x Dim, of GIMP
  PointWeights<Dim> weights;
  std::unique_ptr<CellState<Dim>> state;
  std::vector<Facet<Dim>> facets;  // of the walls
  bool softens_ends = false;       // of walls: whether to look for them
  std::vector<SupportEnd> ends;
  std::vector<LoadedSurface<Dim>> loaded;  // by traction
  std::optional<LoadedSurface<Dim>> skin;  // of nearly incompressible bodies under a body force
  SupportScheme scheme;                    // tightened when the matrix was not positive definite
  Eigen::VectorXd moved;                   // m, of the unknowns since then; empty: nothing
  Eigen::VectorXd imbalance;               // N, of the unknowns then; empty: none
  std::vector<Vec<Dim>> support_forces;    // N, then
  bool located = false, factorised = false, imbalance_due = false;
};

}  // namespace lapilli
