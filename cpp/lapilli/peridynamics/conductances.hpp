#pragma once

#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/heat_settings.hpp"
#include "lapilli/peridynamics/insulation.hpp"

namespace lapilli {

/// Conductances of bonds, G_ij = k V_i V_j w_ij (c_i + c_j)/2 (1 + (l_i - l_j) . Y_ij), W/K: the
/// same seen from both ends, so that heat is conserved to rounding.
///
/// The vectors l are chosen so that the bonds of a point balance, sum of G_ij Y_ij = 0: then fields
/// linear in space give no rate, on irregular points too. They come from damped Jacobi sweeps, many
/// for points at rest, one a step for moving ones, started from the last. c_i is
/// 2 dimension / (sum of w r^2 V). `compact` leaves l = 0 and takes c of a full lattice. Images in
/// adiabatic walls (`corrected`, see Insulation) add to the bond of the point they are images of.
template <int Dim>
class Conductances {
 public:
  /// `conductivity` in W/(m K).
  Conductances(Points& points, const WallSurface& walls, const PeridynamicHeatSettings& settings,
               double conductivity);

  /// Bring families and conductances up to date; false if nothing had moved.
  bool update();
  /// The same without improving l and c, so that looking changes nothing.
  void refresh();
  /// Whether `update` has never run.
  bool first() const { return first_; }

  const Families& families() const { return families_; }
  double operator[](Index bond) const { return conductance_[static_cast<std::size_t>(bond)]; }
  const double* data() const { return conductance_.data(); }
  /// Largest |sum of G Y| / sum of G |Y| over points that no wall touches.
  double imbalance() const;

  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  using Image = typename Insulation<Dim>::Image;

  void find_families();
  /// Conductances of all bonds as l and c are now; then a sweep that improves l by `damping` and,
  /// on request, c.
  void balance(double damping, bool normalise);
  void gather_row(Index point);
  void find_images(Index task);
  void balance_point(Index point, double damping, bool normalise);
  /// Take bonds back that an adiabatic wall hides; what the moment of `point` loses.
  double hide_bonds(Index point, double* out);
  double image_weight(const Image& image, Index owner) const;
  double add_images(Index point, double* out);
  /// The images that a point sees.
  std::span<const Image> images(Index point) const;

  Points& points_;
  const WallSurface& walls_;
  double conductivity_;
  BondWeight weight_;
  double lattice_constant_;
  bool corrected_;
  Families families_;
  Insulation<Dim> insulation_;
  PointArray correction_;         // l, 1/m
  PointArray normaliser_;         // c, 1/m^(Dim+2)
  std::vector<TaskRange> reach_;  // pieces in which the families of a piece lie
  LargeArray<double> rows_;       // a point: x y z V | l c
  LargeArray<double> conductance_;
  std::vector<std::vector<Image>> images_;  // a piece of points
  std::vector<Index> image_begin_;          // in its piece
  Index version_ = -1, ordering_ = -1;
  bool first_ = true, keep_correction_ = false;
};

}  // namespace lapilli
