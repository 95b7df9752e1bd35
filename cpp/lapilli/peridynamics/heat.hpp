#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/core/self_heating.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/peridynamics/fluid.hpp"
#include "lapilli/peridynamics/heat_exchange.hpp"

namespace lapilli {

/// Heat in a fluid (or any set of points) on the thermal horizon: rho c dT/dt = -div q + source.
///
/// Yang, Zhao, Zhu, Feng, Eq. 24 with the sign that conducts (as printed it gathers heat), forward
/// Euler. The capacity of a point, rho c V, is that of its first volume. Points move with the
/// fluid, so convection needs no term. Not modelled: properties that depend on temperature,
/// radiation, heat within walls.
class PeridynamicHeat final : public Physics, public Warnings {
 public:
  PeridynamicHeat(Points& points, std::shared_ptr<WallSurface> walls,
                  const PeridynamicHeatSettings& settings, const Fluid& fluid, bool points_move);

  /// Viscous work per volume and time, W/m^3, that a flow gives; nullptr: none.
  void heat_by(const PointArray* dissipation) { dissipation_ = dissipation; }

  /// How far points were shifted in the last step without having flowed there, m, rows x dimension;
  /// nullptr: not at all.
  void follow_shift(const PointArray* shift) { shift_ = shift; }

  std::string name() const override { return "heat"; }
  StepLimit step_limit() const override;
  StepReport advance(const Step& step) override;
  void refresh_output() override;
  std::vector<Field> fields() override;
  std::vector<Balance> balances() const override;
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;
  std::vector<std::pair<std::string, double>> diagnostics() const override;
  /// Of points at rest: that a linear field would be given a rate, a Laplacian for comparison, heat
  /// lost where a held wall ends within a side.
  std::vector<Note> warnings() const override;

  const PointArray& temperature() const { return temperature_; }  // K
  PointArray& temperature() { return temperature_; }
  const Fluid& material() const { return fluid_; }
  /// Over the volume of the fluid, K.
  double mean_temperature() const;
  /// Heat flow from a wall into the fluid in the last step, W.
  double wall_power(int wall) const { return from_walls_[wall]; }
  /// Mean heat flux into each point from the walls it meets, W/m^2, and the area it meets them
  /// with, m^(dimension - 1); brought up to date by refresh_output().
  const PointArray& wall_heat_flux() const { return wall_heat_flux_; }
  const PointArray& met_area() const { return met_area_; }
  double wall_area(int wall) const { return exchange_->wall_area(wall); }
  const WallSurface& walls() const { return *walls_; }
  const HeatExchange& exchange() const { return *exchange_; }

 private:
  /// What walls prescribe over a span of time: the means of their tables.
  void prescribe_walls(double begin, double end);
  void find_stiffest();
  /// Add what the source of a body gives over a span of time, tables by their means and functions
  /// at its middle, to the rates, and how it falls with the temperature to `source_fall_`.
  void add_source(const FluidBody& body, double begin, double end);
  void find_self_heating();
  void add_dissipation();
  void follow_sources(double size);
  void update_points(const Step& step);
  void interpolate_to_shifted_places();
  double stored() const;
  double span() const;  // J, capacity x range of the temperatures

  Points& points_;
  std::shared_ptr<WallSurface> walls_;
  PeridynamicHeatSettings settings_;
  Fluid fluid_;
  std::unique_ptr<HeatExchange> exchange_;
  PointArray temperature_, capacity_, rate_, wall_heat_flux_, met_area_;
  const PointArray* dissipation_ = nullptr;
  const PointArray* shift_ = nullptr;
  std::vector<WallState> surface_;
  std::vector<double> from_walls_;
  double stiffest_ = 0.0;  // 1/s, largest sum of conductances over capacity
  double source_power_ = 0.0, dissipated_power_ = 0.0;
  std::vector<double> source_fall_;  // W/K, by point; empty where no source is a function
  SelfHeating self_heating_;
  double initial_ = 0.0;
  bool started_ = false, prescribed_ = false, points_move_ = false;
  std::vector<double> supplied_;  // J: walls, source, dissipation
};

}  // namespace lapilli
