#pragma once

#include <span>
#include <utility>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/surface/divide_pieces.hpp"

namespace lapilli {

/// The surface of a body by condition, without the ends of those that come near to holding it.
/// Where such a one ends within a face, the functions of the cells there carry its temperature on,
/// and take up as much heat as if it were .19 cells longer (.05 about the mean, at any place and
/// angle; 6 % of a patch of seven cells). It loses that strip, to a weaker exchange beside it or to
/// nobody.
template <int Dim>
class StrongEnds {
 public:
  /// For the surface of body number `body`, which `division` divides.
  StrongEnds(const HeatProblem<Dim>& problem, std::size_t body, SurfaceDivision<Dim>& division);

  /// A piece that condition number `law` has, as drawn.
  void add(int law, const SurfacePiece<Dim>& piece);
  /// By condition; those of which little would be left as they are drawn. Enters what ends.
  std::vector<std::vector<SurfacePiece<Dim>>> pieces(SurfaceFound& found) const;

 private:
  /// Who has a strip of a piece, which condition is beside it (or nobody), and its width, m.
  struct Strip {
    int heir = SurfaceDivision<Dim>::nobody, beside = SurfaceDivision<Dim>::nobody;
    double width = 0.0;
  };

  struct Parts {
    double beyond = 0.0;  // m^(dim-1), outside of its region
    std::vector<SurfacePiece<Dim>> kept;
    std::vector<std::pair<int, SurfacePiece<Dim>>> lost;  // with who has them
    std::vector<double> lost_beside;                      // m^(dim-1), by condition
    int held_beside = -1;
  };

  double reach(int law, int beside, const Vec<Dim>& normal) const;
  Strip strip_of(int law, const SurfacePiece<Dim>& piece);

  const HeatProblem<Dim>& problem_;
  const HeatBody& body_;
  SurfaceDivision<Dim>& division_;
  std::vector<double> coefficient_;  // W/(m^2 K), by condition; 0 of fluxes
  double cell_ = 0.0;                // m; 0 where no region ends
  std::vector<Parts> parts_;         // by condition
};

/// What to warn of where a surface that is held, or all but, is so narrow that its ends tell.
std::vector<Note> narrow_holds(std::span<const SurfaceFound> found, const HeatSettings& settings);

/// What to warn of where a condition has surface that its region does not reach.
std::vector<Note> regions_below(std::span<const SurfaceFound> found, const HeatSettings& settings,
                                double cell_size);

/// What to warn of, on materials that vary, where two held temperatures meet within a face.
std::vector<Note> steps_between(std::span<const SurfaceFound> found, const HeatSettings& settings);

}  // namespace lapilli
