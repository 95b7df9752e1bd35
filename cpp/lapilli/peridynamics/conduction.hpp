#pragma once

#include <vector>

#include "lapilli/peridynamics/conductances.hpp"
#include "lapilli/peridynamics/heat_exchange.hpp"

namespace lapilli {

/// Heat exchange along bonds: rate into i = sum over its bonds of G_ij (T_j - T_i), W, with the
/// conductances of `Conductances`.
///
/// Walls lie where their surface is, not at their points: a wall point at depth d_j shows the fluid
/// point i at distance d_i the temperature T_s + (T_s - T_i) d_j/d_i. An adiabatic wall shows the
/// mirror image of the fluid (`corrected`) or nothing (`compact`).
template <int Dim>
class Conduction final : public HeatExchange {
 public:
  Conduction(Points& points, const WallSurface& walls, const PeridynamicHeatSettings& settings,
             double conductivity);

  void update() override;
  void refresh() override;
  void rates(const double* temperature, const std::vector<WallState>& surface, double* rate,
             std::vector<double>& from_walls) const override;
  void add_missed(const double* temperature, const std::vector<WallState>& surface,
                  const double* shift, double* missed) const override;
  void diagonal(double* sum) const override;
  void wall_rows(const double* temperature, const std::vector<WallState>& surface, double* flux,
                 double* area) const override;
  double wall_area(int wall) const override { return wall_area_[wall]; }
  double imbalance() const override { return bonds_.imbalance(); }
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;

 private:
  struct WallBond {
    int wall;
    double area;      // m^(Dim-1)
    double distance;  // of the fluid point from the surface, m
  };

  /// What share of the area that its bonds stand for a wall's flux goes through, so that flux times
  /// the area it shares with the fluid comes in, however the bonds lie.
  void share_area(bool first);
  template <class Body>
  void for_wall_bonds(Index point, const Body& body) const;
  double flux_through(const WallBond& bond, const WallState& state, double temperature) const;
  const Families& families() const { return bonds_.families(); }
  const double* position(Index point) const { return points_.position().data() + point * Dim; }

  const Points& points_;
  const WallSurface& walls_;
  double conductivity_;
  Conductances<Dim> bonds_;
  bool areas_matter_ = false;      // some wall prescribes a flux per area
  std::vector<double> share_;      // by wall; 1 where it prescribes a temperature
  std::vector<double> wall_area_;  // m^(Dim-1), shared with the fluid at the start
};

}  // namespace lapilli
