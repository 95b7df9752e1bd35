#pragma once

#include <memory>

#include "lapilli/core/self_heating.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"
#include "lapilli/mpm/heat/nodal_enthalpy.hpp"
#include "lapilli/mpm/heat/nodal_range.hpp"
#include "lapilli/mpm/heat/point_fields.hpp"
#include "lapilli/mpm/heat/steps_ahead.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/mpm/surface/surface_view.hpp"

namespace lapilli {

/// Heat conduction in bodies at rest whose shapes are known and whose properties depend on the
/// temperature, or that melt, or that touch with a thermal resistance: nodes carry the enthalpy H
/// of their volume, conduction acts on Kirchhoff's potential of the temperature T(H), and the
/// surface is taken implicitly by Newton's method in H, all of it explicit in the conduction:
///   H + dt M (T(H) - T) = H0 + dt (-sum of K_b phi_b(T) + sources + E(T)).
template <int Dim>
class EnthalpyHeat final : public Physics,
                           public HasSurface,
                           public Warnings,
                           public TellsStepsAhead {
 public:
  EnthalpyHeat(Points& points, HeatProblem<Dim> problem);

  std::string name() const override { return "heat"; }
  StepLimit step_limit() const override;
  StepsAhead steps_ahead() const override;
  StepReport advance(const Step& step) override;
  void refresh_output() override;
  std::vector<Field> fields() override;
  std::vector<Balance> balances() const override;
  std::vector<std::pair<std::string, double>> diagnostics() const override;
  SurfaceView surface() const override;
  std::vector<Note> warnings() const override;
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;

 private:
  using Vector = SurfaceTerm::Vector;

  /// A part with the heat of its nodes, by place.
  struct Solved {
    HeatPart<Dim> part;
    NodalEnthalpy<Dim> enthalpy;
    std::vector<double> stored;  // J
    std::vector<double> heat;    // J, that comes in the step
    std::vector<double> potential;
    NodalRange<Dim> range;
  };
  /// A node near a surface, as an unknown of the one system over all parts.
  struct Unknown {
    std::size_t part;
    Index place;
  };

  void connect_surface();
  void bound_step();
  /// Where the unknowns of a part begin among all.
  int first_unknown(std::size_t part) const;
  /// Laws on the surface that exchange with the surroundings; those of contacts follow.
  std::size_t outer_laws() const { return problem_.settings.boundaries.size(); }

  // The phases of a step.
  void conduct(Solved& one, double size) const;
  void release_sources(Solved& one, const Step& step);
  void find_self_heating();
  void exchange_with_surroundings(const Step& step);
  void store(Solved& one) const;

  /// Newton's method for the heat of the unknowns at the end of a step, J, from that at its start;
  /// `coming` (J) is what comes without the surface.
  Vector solve_surface(double size, const Vector& start, const Vector& coming);
  bool bears_explicitly(double size) const;
  /// The liquid share of body number `body` of a part at a node.
  double liquid_at(const Solved& one, std::size_t body, Index place) const;
  template <class Values>
  Vector gather(const Values& values) const;

  Points& points_;
  HeatProblem<Dim> problem_;
  HeatCoefficients<Dim> coefficients_;
  SurfaceConditions laws_;
  StepLimit limit_;
  std::vector<SurfaceFound> found_;
  std::vector<Solved> solved_;
  std::vector<std::size_t> part_of_, number_in_part_;  // by body

  std::vector<ResistingContact> contacts_;
  std::vector<double> through_contact_;  // J from the first body to the second
  std::vector<Unknown> unknown_;
  std::vector<std::array<int, 3>> coordinates_;  // of the unknowns on the grid
  SurfaceTerm surface_;
  SurfaceSolver solver_;
  std::vector<double> exchange_rate_;  // by law, per W/(m^2 K), 1/s

  TemperatureRange range_;  // that conduction and exchange can reach
  bool melts_ = false, has_sources_ = false;
  double initial_ = 0.0, source_ = 0.0;  // J
  SelfHeating self_heating_;
  double time_ = 0.0;  // s
  std::unique_ptr<PointArray> output_temperature_, output_flux_, output_liquid_;
};

}  // namespace lapilli
