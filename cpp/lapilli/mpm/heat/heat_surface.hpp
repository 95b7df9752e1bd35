#pragma once

#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/heat/point_fields.hpp"

namespace lapilli {

/// Areas of the surface nodes by the method of the scene: nodal normals, the paper's particle
/// normals, or exact faces. Follows the points as they move.
template <int Dim>
class HeatSurface {
 public:
  HeatSurface(const Points& points, const HeatProblem<Dim>& problem);

  /// Areas at the points' present places. `sums` were taken there too.
  NodalAreas<Dim> areas(const Points& points, const HeatCoefficients<Dim>& coefficients,
                        const NodalSums<Dim>& sums);
  /// Of the points that `areas` was asked for last.
  const OutsideCells<Dim>& outside() const { return outside_; }

  void save(Archive& archive, const std::string& name) const { outside_.save(archive, name); }
  void load(const Archive& archive, const std::string& name) { outside_.load(archive, name); }

 private:
  const HeatProblem<Dim>& problem_;
  WallContact<Dim> contact_;
  OutsideCells<Dim> outside_;
  Index version_;  // of the points that outside_ belongs to
};

/// Yu & Zhao (2026), Algorithm 1 with n_p = -grad phi: surface nodes are those of every cell filled
/// to less than `fraction` (empty ones included), A_I = sum V_p n_p . grad S_Ip.
template <int Dim>
NodalAreas<Dim> paper_areas(const Points& points, const HeatProblem<Dim>& problem,
                            const HeatCoefficients<Dim>& coefficients, const NodalSums<Dim>& sums);

/// Exact areas of the faces between occupied and outside cells, shared among their nodes: for
/// bodies whose surface lies on grid lines.
template <int Dim>
NodalAreas<Dim> face_areas(const Grid<Dim>& grid, const Points& points,
                           std::span<const unsigned char> outside);

}  // namespace lapilli
