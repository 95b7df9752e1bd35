#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/peridynamics/bond_scratch.hpp"
#include "lapilli/peridynamics/bond_sums.hpp"
#include "lapilli/peridynamics/borne_weight.hpp"
#include "lapilli/peridynamics/equation_of_state.hpp"
#include "lapilli/peridynamics/flow.hpp"
#include "lapilli/peridynamics/stress_force.hpp"
#include "lapilli/peridynamics/velocity_noise.hpp"

namespace lapilli {

/// Points worked on as one piece.
inline constexpr Index flow_piece = 128;

/// Semi-Lagrangian peridynamics of a weakly compressible Newtonian fluid (Yang, Zhao, Zhu, Feng,
/// Eqs. 26, 27, 33-36, 38), velocity Verlet.
///
/// Differs from the paper where its equations do not run: stress from the new density (not Eq. 35),
/// shifting away from neighbours (not Eq. 38), a uniform weight left to its own pressure, a
/// diffusion of density that leaves alone what bears the weight (as Fourtakas et al. 2019). Walls
/// are layers of points that carry pressure; a wall point at depth d_j shows a fluid point at
/// distance d_i the velocity v_s + (v_s - v_i) d_j/d_i. Not modelled: free surfaces, turbulence, a
/// second fluid.
template <int Dim>
class PeridynamicFlow final : public Flow, public Warnings {
 public:
  PeridynamicFlow(Points& points, std::shared_ptr<WallSurface> walls,
                  const PeridynamicFlowSettings& settings, const Fluid& fluid,
                  const PeridynamicHeat* heat, bool with_dissipation, PrintedEquations printed);

  std::string name() const override { return "flow"; }
  StepLimit step_limit() const override;
  StepReport advance(const Step& step) override;
  void refresh_output() override;
  std::vector<Field> fields() override;
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;
  std::vector<std::pair<std::string, double>> diagnostics() const override;
  /// That the points are too few for the layers that flow and heat form.
  std::vector<Note> warnings() const override;

  const PointArray& velocity() const override { return velocity_; }
  PointArray& velocity() override {
    fastest_known_ = false;
    return velocity_;
  }
  const PointArray& density() const override { return density_; }
  const PointArray* dissipation() const override { return dissipation_.get(); }
  const PointArray* shifted() const override { return &shifted_; }
  double sound_speed() const override { return sound_speed_; }
  double velocity_noise() const override {
    return lapilli::velocity_noise<Dim>(*walls_, families_, weight_, velocity_);
  }
  std::pair<double, double> density_variation() const override {
    return {least_density_ / fluid_.density - 1.0, most_density_ / fluid_.density - 1.0};
  }
  double smallest_spacing() const override { return smallest_spacing_ / walls_->spacing(); }
  Index searches() const override { return families_.searches(); }

 private:
  void start();
  /// Start with the pressure that bears the weight: without it sound would have to bring it.
  void balance_density();
  void find_fastest();
  double fastest_squared(Index begin, Index end) const;  // m^2/s^2
  /// A uniform excess would only press the fluid together: buoyancy is that over the mean.
  void find_reference();
  void kick_and_drift(const Step& step);
  void find_families();
  void gather_rows();
  void gather_row(Index point);
  /// Density, then acceleration and the second half of the kick, piece by piece.
  void update_density_and_kick(double step_size);
  /// New density and pressure, stress rows and viscous force of one piece.
  void update_density(Index task, double step_size);
  void update_point(Index point, const BondSums<Dim>& sums, double step_size);
  /// Acceleration of one piece from stress rows and body force.
  void accelerate_and_kick(Index task, double step_size);
  /// What the mean gradient does not explain of velocity differences, as a force per volume, N/m^3.
  Vec<Dim> zero_energy(Index point, const double* weights) const;
  void check_density();
  /// Root mean square of the velocity beside that of the vessel, m/s, and width of the fluid, m.
  struct Pace {
    double speed, width;
  };
  Pace pace() const;

  /// Share of gravity by which a point is heavier than the fluid in the mean, 1.
  double share_of_gravity(Index point) const;
  /// Mean place of the fluid, m.
  Vec<Dim> middle() const;
  Vec<Dim> body_force(Index point) const {  // acceleration, m/s^2
    return share_of_gravity(point) * gravity_;
  }
  bool fluid(Index point) const { return walls_->wall(point) < 0; }

  static constexpr Index row_size = flow_row_size;

  Points& points_;
  std::shared_ptr<WallSurface> walls_;
  PeridynamicFlowSettings settings_;
  Newtonian fluid_;
  const PeridynamicHeat* heat_;
  double reference_ = 0.0;  // K, where buoyancy vanishes
  PrintedEquations printed_;
  BondWeight weight_;
  double lattice_constant_;
  Vec<Dim> gravity_;
  double sound_speed_;
  EquationOfState pressure_;
  bool two_field_;
  bool walls_slide_ = false;  // any wall has a velocity

  PointArray velocity_, acceleration_, density_, mass_, shift_, shifted_, pressure_field_;
  std::unique_ptr<PointArray> dissipation_;
  StressForce<Dim> force_;
  Families families_;
  std::optional<BorneWeight<Dim>> borne_;  // where temperature gives weight
  LargeArray<double> rows_;
  BondScratch bond_weights_;                        // w V, from the density to the force
  std::vector<Mat<Dim>> gradient_, inverse_shape_;  // kept for two fields only
  std::vector<TaskRange> reach_;                    // pieces in which the families of a piece lie
  std::vector<double> piece_least_, piece_most_, piece_spacing_, piece_fastest_, piece_farthest_;
  double least_density_, most_density_, smallest_spacing_;
  bool started_ = false, fastest_known_ = false;
  double age_ = 0.0;  // s, since the start
};

}  // namespace lapilli
