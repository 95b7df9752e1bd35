#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/heat_exchange.hpp"
#include "lapilli/peridynamics/operators.hpp"

namespace lapilli {

/// Heat exchange as the paper writes it (Eqs. 28, 29, with the sign that conducts): flux from the
/// gradient, rate from the divergence, on request with the zero-energy term.
///
/// Without that term the alternating field has no gradient and is not smoothed; kept for
/// comparison, as are walls that hold their temperature half a spacing behind the face. With it,
/// the temperature holds on the face: a wall point shows a fluid point what lies beyond in line
/// with the family of that point, and the flux that it has. Adiabatic walls take no part. A
/// prescribed flux (section 4.3) is handed to the fluid points in front of each wall point, times
/// its share of the wall's area, whose sum stays that of the start: set as the flux of the wall's
/// own points it would bring in 2.2 times its heat, since a fluid point gains its own flux as well.
template <int Dim>
class TwoFieldConduction final : public HeatExchange {
 public:
  /// Throws std::invalid_argument for a wall with convection.
  TwoFieldConduction(Points& points, const WallSurface& walls,
                     const PeridynamicHeatSettings& settings, double conductivity);

  void update() override;
  void refresh() override { update(); }
  void rates(const double* temperature, const std::vector<WallState>& surface, double* rate,
             std::vector<double>& from_walls) const override;
  void diagonal(double* sum) const override { std::fill(sum, sum + points_.size(), 0.0); }
  void wall_rows(const double* temperature, const std::vector<WallState>& surface, double* flux,
                 double* area) const override;
  double wall_area(int wall) const override;
  double imbalance() const override;
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;

 private:
  /// A fluid point in front of a wall that prescribes a flux.
  struct FluxShare {
    std::int32_t point;
    int wall;
    double area;  // m^(Dim-1)
  };

  void share_fluxes();
  bool holds_on_face() const { return settings_.laplacian == Laplacian::zero_energy; }
  /// How much warmer a fluid point sees a wall point that holds a temperature, K.
  double rise_beyond(Index point, Index wall_point, std::span<const double> temperature,
                     double of_wall) const;
  double rise_to(Index i, Index j, std::span<const double> temperature,
                 const std::vector<WallState>& surface) const;
  std::vector<Vec<Dim>> inward_fluxes(std::span<const double> temperature,
                                      const std::vector<WallState>& surface) const;
  Index in_front(Index wall_point, Index owner) const;
  bool prescribes_flux(Index wall_point) const {
    return walls_.walls()[walls_.wall(wall_point)].settings.heat == WallHeat::flux;
  }
  bool first_layer(Index point) const { return walls_.depth(point) < 0.99 * walls_.spacing(); }

  Points& points_;
  const WallSurface& walls_;
  PeridynamicHeatSettings settings_;
  double conductivity_;
  BondWeight weight_;
  Families families_;
  std::optional<NonlocalOperators<Dim>> operators_;
  std::vector<double> volume_;
  std::vector<FluxShare> flux_shares_;
  std::vector<double> flux_area_;  // of each wall, at the start
  Index version_ = -1, ordering_ = -1;
};

}  // namespace lapilli
