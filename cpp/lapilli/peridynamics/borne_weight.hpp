#pragma once

#include <span>
#include <vector>

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// The differences of pressure by which a fluid at rest bears its weight: between two points the
/// mean of their body forces along their bond, rho (b_i + b_j)/2 . Y.
///
/// Body forces are shares of one gravity. A wall point at depth d_j shows a fluid point at distance
/// d_i the share s + (s - s_i) d_j/d_i, where the surface has a share s, and otherwise that of the
/// fluid point itself.
template <int Dim>
class BorneWeight {
 public:
  /// `gravity` in m/s^2. The others must outlive the object.
  BorneWeight(const WallSurface& walls, const Families& families, const Vec<Dim>& gravity);

  /// The share of gravity that acts on a point where it is now, 1; of a wall that of its surface,
  /// NaN where it has none.
  void set(Index point, double share);
  /// Sum over the bonds of a point of w V (b_i + b_j)/2 . Y, m^2/s^2; `weights` are w V, 1.
  double of_point(Index point, const double* weights) const;
  /// Pressure over density, m^2/s^2, that bears the weight; its mean over the fluid is zero. What
  /// of the body force no pressure balances sets the fluid in motion. Solves sum of w V_j (p_j -
  /// p_i) = of_point(i), without the bonds between walls, by conjugate gradients. `weights` are w,
  /// 1, one a bond; `volume` in m^Dim.
  std::vector<double> pressure(std::span<const double> weights,
                               std::span<const double> volume) const;

 private:
  struct Pull {
    double share = 0.0;      // 1, of fluid points; walls have none of their own
    double potential = 0.0;  // m^2/s^2, gravity . x
  };

  /// Mean share of a bond between fluid and wall.
  double mean_share(Index fluid, Index wall) const;

  const WallSurface& walls_;
  const Families& families_;
  Vec<Dim> gravity_;
  std::vector<Pull> pull_;       // by point
  std::vector<double> surface_;  // share, by point of a wall
};

}  // namespace lapilli
