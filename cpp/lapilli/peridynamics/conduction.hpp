#pragma once

#include <vector>

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/heat_exchange.hpp"

namespace lapilli {

/// Heat exchange along bonds: rate into i = sum over its bonds of G_ij (T_j - T_i), W.
///
/// G_ij = k V_i V_j w_ij (c_i + c_j)/2 (1 + (l_i - l_j) . Y_ij) is the same seen from both ends, so
/// heat is conserved to rounding. The vectors l are chosen so that the bonds of a point balance,
/// sum of G_ij Y_ij = 0: then fields linear in space give no rate, on irregular points too. They
/// come from damped Jacobi sweeps, many for points at rest, one a step for moving ones, started
/// from the last. c_i is 2 dimension / (sum of w r^2 V). `compact` leaves l = 0 and takes c of a
/// full lattice.
///
/// Walls lie where their surface is, not at their points: a wall point at depth d_j shows the fluid
/// point i at distance d_i the temperature T_s + (T_s - T_i) d_j/d_i. An adiabatic wall shows the
/// mirror image of the fluid (`corrected`: a bond between two points at distances d_i, d_j from it
/// has an image of length sqrt(r^2 + 4 d_i d_j)) or nothing (`compact`). Two adiabatic walls in one
/// corner: the image across both is left out.
template <int Dim>
class Conduction final : public HeatExchange {
 public:
  Conduction(Points& points, const WallSurface& walls, const PeridynamicHeatSettings& settings);

  void update() override;
  void refresh() override;
  void rates(const double* temperature, const std::vector<WallState>& surface, double* rate,
             std::vector<double>& from_walls) const override;
  double wall_flux(int wall, const Vec3& place, double reach, const double* temperature,
                   const std::vector<WallState>& surface) const override;
  double wall_area(int wall) const override { return wall_area_[wall]; }
  double imbalance() const override;
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;

 private:
  struct WallBond {
    Index wall_point;
    int wall;
    double area;      // m^(Dim-1)
    double distance;  // of the fluid point from the surface, m
  };

  void weigh_bonds();
  void gather_rows();
  void weigh();
  void find_images();
  void balance(double damping);
  double add_images(Index point, double* out);
  void measure_walls();
  template <class Body>
  void for_wall_bonds(Index point, const Body& body) const;
  double flux_through(const WallBond& bond, const WallState& state, double temperature) const;

  Points& points_;
  const WallSurface& walls_;
  PeridynamicHeatSettings settings_;
  BondWeight weight_;
  double lattice_constant_;
  bool corrected_;
  Families families_;
  PointArray correction_;           // l, 1/m
  PointArray normaliser_;           // c, 1/m^(Dim+2)
  std::vector<double> rows_;        // a point: x y z V | l c
  std::vector<double> insulation_;  // distance from the nearest adiabatic wall, m
  std::vector<const double*> insulation_normal_;
  std::vector<double> bond_weight_, image_weight_, conductance_;
  std::vector<double> bond_area_, wall_area_;  // as bonds see it now, and at the start
  Index version_ = -1, ordering_ = -1;
  bool first_ = true, keep_correction_ = false;
};

}  // namespace lapilli
