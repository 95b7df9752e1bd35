#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "lapilli/core/says_model.hpp"
#include "lapilli/core/self_heating.hpp"
#include "lapilli/core/stores_in_points.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/mpm/heat/boundary_conditions.hpp"
#include "lapilli/mpm/heat/heat_fields.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/heat/heat_source.hpp"
#include "lapilli/mpm/heat/heat_surface.hpp"
#include "lapilli/mpm/heat/obstacle_exchange.hpp"
#include "lapilli/mpm/heat/point_grid_transfer.hpp"
#include "lapilli/mpm/heat/sub_cycle.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/mpm/transfer/cell_order.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {

/// Heat conduction on points that carry temperature, and may move: points -> grid -> points every
/// step. All transfers are one update with a blend beta,
///
///   T_p <- (1 - beta) T_p + S . (dT + beta T)      G_p <- (1 - beta) G_p + grad S . (dT + beta T)
///
/// FLIP and PIC have no gradient G and beta 0 and 1; TPIC has beta 1; `affine` has
/// beta = 1 - exp(-c dt alpha/h^2), so that its smoothing does not depend on the step.
template <int Dim>
class ParticleHeat final : public Physics,
                           public HasSurface,
                           public SaysModel,
                           public StoresInPoints,
                           public Warnings {
 public:
  ParticleHeat(Points& points, HeatProblem<Dim> problem);

  std::string name() const override { return "heat"; }
  StepLimit step_limit() const override;
  StepReport advance(const Step& step) override;
  void refresh_output() override;
  std::vector<Field> fields() override;
  std::vector<Balance> balances() const override;
  std::vector<double> stored_in(std::span<const Index> rows) const override;
  void release(std::span<const Index> rows) override;
  std::vector<std::pair<std::string, double>> diagnostics() const override;
  std::vector<Note> warnings() const override;
  std::vector<std::string> modelled() const override;
  SurfaceView surface() const override { return laws_.surface(); }
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;

  /// What points carry, K: for laws of other physics, and for them to add heat to.
  PointArray& carried_temperature() { return temperature_; }
  PointArray* carried_gradient() { return gradient_.get(); }  // K/m; null for flip and pic
  const PointArray& capacity() const { return capacity_; }    // rho0 c V0, J/K
  /// Let points go on with the heat that they had in another run or stage: the temperature that
  /// they carried, where the state knows heat, and the capacity of their mass, which stays while
  /// their volume changes. Before the first step.
  void go_on(const PointStart& start);
  /// Let heat take steps of its own, whatever those of the clock, where the settings allow it.
  void follow(SubCycle::Motion motion);
  /// Give bodies whose motion can part, those of several fields, temperatures of their own at the
  /// nodes; before the first step.
  void separate(const NodeFields<Dim>& fields, FindTouches touches);
  /// Where material touches the obstacles of the problem; before the first step.
  void touch(std::vector<FindFeet<Dim>> feet);
  /// Null where heat takes the steps of the clock.
  const SubCycle* sub_cycle() const { return sub_cycle_.get(); }
  /// Have an entry of the balance, from the start, for heat of plastic work, for points that leave.
  void expect_plastic() { books_plastic_ = true; }
  void expect_removed() { books_removed_ = true; }
  /// Book heat that another physics added to the carried temperatures, J.
  void book_plastic(double heat) {
    plastic_ += heat;
    range_ = {};
  }

 private:
  void start_with(const std::vector<double>& capacity, const std::vector<double>& temperature);
  void bound_carried_step();
  void bound_step();
  StepLimit own_limit() const;
  void take_due(const SubCycle::Due& due);
  void take_step(const Step& step);

  // The phases of a step.
  void project_to_grid();
  void project_to_grid(const double* temperature);
  void compare_with_shapes();
  AreaRatios::Found areas_without_others(const std::vector<std::size_t>& bodies) const;
  void find_surface();
  void conduct(const Step& step);
  void exchange_with_surroundings(const Step& step);
  void solve_nodes(const Step& now);
  void relax_points();
  void update_points(const Step& step);

  void exchange_at_points(const Step& step);
  void exchange_at_nodes(double step);
  void heat_by_sources(const Step& step);
  void find_self_heating(double time);
  double blend(double step) const;
  /// What points take from.
  PointGridTransfer<Dim>& carrier() { return fields_ ? fields_->nodes() : grid_; }
  StepLimit separate_limit() const;
  void make_room_to_show();
  void show(const std::vector<double>& nodal);
  std::vector<double> supplied() const;
  double exchange_rate() const;
  std::vector<double> temperature_now() const;
  void require_finite() const;
  /// Throws RunError when nodes have left every temperature that the scene can reach.
  void require_in_range() const;

  Points& points_;
  HeatProblem<Dim> problem_;
  HeatCoefficients<Dim> coefficients_;
  HeatTransfer transfer_;
  bool affine_;  // points carry a gradient
  PointArray temperature_, capacity_;
  std::unique_ptr<PointArray> gradient_;
  CellOrder<Dim> order_;
  PointGridTransfer<Dim> grid_;
  std::unique_ptr<HeatFields<Dim>> fields_;  // null where all bodies share the nodes
  BoundaryConditions<Dim> laws_;
  std::unique_ptr<HeatSurface<Dim>> surface_;
  std::pair<Index, Index> surface_found_{-1, -1};  // version and ordering of the points
  std::optional<HeatSource<Dim>> source_;
  ObstacleExchange<Dim> obstacles_;
  // FLIP under strong exchange (coefficient h / conductivity > 1): the share of the gap to the
  // surroundings that a node closed in the step, zero elsewhere. Points follow by the same share;
  // by increments alone they would be carried past the surroundings.
  std::vector<double> relaxation_;
  double conductivity_ = 0.0;  // the least of the bodies, W/(m K)
  bool relaxes_ = false;       // some node in this step
  std::unique_ptr<SubCycle> sub_cycle_;
  StepLimit limit_;
  double carried_limit_ = std::numeric_limits<double>::infinity();  // s, of FLIP at the start
  TemperatureRange range_;
  SelfHeating self_heating_;
  Index limited_ordering_ = -1;  // ordering that limit_ was bounded for
  double initial_ = 0.0;         // J
  double plastic_ = 0.0;         // J, from plastic work
  double removed_ = 0.0;         // J, of points that were removed
  bool books_plastic_ = false, books_removed_ = false;
  double area_ = 0.0, negative_share_ = 0.0;

  std::unique_ptr<PointArray> output_temperature_, output_flux_;
  std::unique_ptr<PointArray> output_carried_;  // K, at the time of the clock; with sub_cycle_
  bool output_is_current_ = false;
};

}  // namespace lapilli
