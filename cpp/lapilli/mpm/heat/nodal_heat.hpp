#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "lapilli/algebra/stencil_matrix.hpp"
#include "lapilli/core/self_heating.hpp"
#include "lapilli/mpm/heat/boundary_conditions.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/heat/heat_source.hpp"
#include "lapilli/mpm/heat/heat_surface.hpp"
#include "lapilli/mpm/heat/surface_conditions.hpp"
#include "lapilli/mpm/heat/theta_solver.hpp"

namespace lapilli {

/// Heat conduction where no point moves. Conduction, surface and sources are assembled once into
/// nodal operators; a step touches nodes only, and point values are recovered when somebody looks.
///
/// Transfers, as they close on the nodes (K conduction, C lumped capacity, M = sum m S S^T):
///   kept  T <- T + dT
///   flip  T <- T + C^-1 M dT     (points carry T_p + S . sum of dT)
///   pic   T <- C^-1 M (T + dT)   (points carry S . (T + dT))
template <int Dim>
class NodalHeat final : public Physics, public HasSurface {
 public:
  NodalHeat(Points& points, HeatProblem<Dim> problem);

  std::string name() const override { return "heat"; }
  StepLimit step_limit() const override;
  StepReport advance(const Step& step) override;
  void refresh_output() override;
  std::vector<Field> fields() override;
  std::vector<Balance> balances() const override;
  std::vector<std::pair<std::string, double>> diagnostics() const override;
  SurfaceView surface() const override { return laws_.surface(); }
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;

 private:
  void assemble();
  /// Find the surface and the nodes of each condition.
  void assign_laws(const NodalSums<Dim>& sums, const std::function<bool(Index)>& is_active);
  void bound_step();
  void find_self_heating(double time);

  // The phases of an explicit step.
  void conduct(double step);
  void exchange_with_surroundings(const Step& step);
  void hand_back_to_points();

  using LawRates = std::vector<std::vector<double>>;  // by law and node
  class ThetaStep;
  StepReport advance_implicitly(const Step& step);
  /// Book the heat that nodes were `given`, that of shared nodes as each law gave `heat`.
  void book_laws(std::vector<double>& given, const LawRates& heat);

  void require_finite() const;
  bool carries_points() const { return transfer_ != HeatTransfer::nodal; }

  Points& points_;
  HeatProblem<Dim> problem_;
  HeatCoefficients<Dim> coefficients_;
  HeatTransfer transfer_;
  BoundaryConditions<Dim> laws_;
  SurfaceConditions in_time_;  // when tables jump
  std::optional<HeatSource<Dim>> source_;
  SelfHeating self_heating_;
  StepLimit limit_;
  double initial_ = 0.0;         // J
  double negative_share_ = 0.0;  // of the surface

  std::unique_ptr<NodeRows<Dim>> rows_;
  std::unique_ptr<StencilMatrix<Dim>> conduction_, capacity_;  // K; M where the transfer needs it
  std::unique_ptr<ThetaSolver<Dim>> theta_;
  // One value a place of rows_; zero where inactive.
  std::vector<double> lumped_, inverse_;  // C, 1/C
  std::vector<double> temperature_;       // at the start of the next step
  std::vector<double> updated_;           // T + dT of the last step: what output interpolates
  std::vector<double> increment_;         // dT
  std::vector<double> total_;             // sum of dT since the start (flip)

  // Point values, made when first looked at.
  std::unique_ptr<PointArray> start_;  // carried temperature at the start (flip)
  std::unique_ptr<PointArray> output_temperature_, output_carried_, output_flux_;
};

}  // namespace lapilli
