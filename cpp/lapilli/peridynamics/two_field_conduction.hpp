#pragma once

#include <algorithm>
#include <optional>

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/heat_exchange.hpp"
#include "lapilli/peridynamics/operators.hpp"

namespace lapilli {

/// Heat exchange as the paper writes it (Eqs. 28, 29, with the sign that conducts): flux from the
/// gradient, rate from the divergence, on request with the zero-energy term.
///
/// Without that term the alternating field has no gradient and is not smoothed; kept for
/// comparison. Walls with a temperature take part with their first layer, which holds that
/// temperature; adiabatic walls not at all. Walls that prescribe a flux are refused: with the flux
/// set at their points a fluid point gains its own flux as well, and 2.2 times the heat comes in.
template <int Dim>
class TwoFieldConduction final : public HeatExchange {
 public:
  /// Throws std::invalid_argument for a wall with a flux or convection.
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
  void save(Archive& archive) const override { families_.save(archive, "heat/families"); }
  void load(const Archive& archive) override;

 private:
  bool first_layer(Index point) const { return walls_.depth(point) < 0.99 * walls_.spacing(); }

  Points& points_;
  const WallSurface& walls_;
  PeridynamicHeatSettings settings_;
  double conductivity_;
  BondWeight weight_;
  Families families_;
  std::optional<NonlocalOperators<Dim>> operators_;
  std::vector<double> volume_;
  Index version_ = -1, ordering_ = -1;
};

}  // namespace lapilli
