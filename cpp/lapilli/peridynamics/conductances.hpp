#pragma once

#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/peridynamics/bond_tensor.hpp"
#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/heat_settings.hpp"
#include "lapilli/peridynamics/insulation.hpp"

namespace lapilli {

/// Points worked on as one piece.
inline constexpr Index conductance_piece = 128;

/// Conductances of bonds, G_ij = k V_i V_j w_ij y . (C_i + C_j) y / 2 (1 + (l_i - l_j) . Y_ij),
/// W/K, y = Y/|Y|: the same seen from both ends, so that heat is conserved to rounding.
///
/// The vectors l are chosen so that the bonds of a point balance, sum of G_ij Y_ij = 0: then fields
/// linear in space give no rate, on irregular points too. They come from damped Jacobi sweeps, many
/// for points at rest, one a step for moving ones, started from the last. So do the symmetric C,
/// such that sum of G Y Y = 2 k V_i 1: where points conduct better along one direction than along
/// another, as they come to lie, all together conduct too little, however fine they are. `compact`
/// leaves l = 0 and takes C of a full lattice. Images in adiabatic walls (`corrected`, see
/// Insulation) add to the bond of the point they are images of.
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
  using Row = ConductanceRow<Dim>;
  /// What the bonds of a point add up to, with s = 2 G/(k V_i).
  struct Sums {
    Vec<Dim> outward = Vec<Dim>::Zero();  // sum of s Y
    Mat<Dim> shape = Mat<Dim>::Zero();    // sum of s Y Y
    double moment = 0.0;                  // sum of w V Y^2 (1 + tilt)

    void add(const Vec<Dim>& bond, double s, double w) {
      outward += s * bond;
      shape += s * bond * bond.transpose();
      moment += w * bond.squaredNorm();
    }
  };

  void find_families();
  /// Conductances of all bonds as l and c are now; then a sweep that improves l by `damping` and,
  /// on request, c.
  void balance(double damping, bool normalise);
  void gather_row(Index point);
  void find_images(Index task);
  void balance_point(Index point, double damping, bool normalise);
  /// Conductances of the bonds of a point, before adiabatic walls.
  Sums sum_row(Index point);
  /// Take bonds back that an adiabatic wall hides.
  void hide_bonds(Index point, Sums& sums);
  double image_weight(const Image& image, Index owner) const;
  /// Images carry the mean of C: seen from both ends their bonds have two directions.
  void add_images(Index point, Sums& sums);
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
  PointArray normaliser_;         // C, 1/m^(Dim+2)
  std::vector<TaskRange> reach_;  // pieces in which the families of a piece lie
  LargeArray<double> rows_;       // see ConductanceRow
  LargeArray<double> conductance_;
  std::vector<std::vector<Image>> images_;  // a piece of points
  std::vector<Index> image_begin_;          // in its piece
  Index version_ = -1, ordering_ = -1;
  bool first_ = true, keep_correction_ = false;
};

}  // namespace lapilli
