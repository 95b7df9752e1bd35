#pragma once

#include <limits>
#include <memory>

#include "lapilli/core/self_heating.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/mpm/heat/adaptive_steps.hpp"
#include "lapilli/mpm/heat/follows_changes.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"
#include "lapilli/mpm/heat/nodal_range.hpp"
#include "lapilli/mpm/heat/point_fields.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/mpm/heat/weak_exchange.hpp"
#include "lapilli/mpm/surface/surface_view.hpp"

namespace lapilli {

/// Heat conduction in bodies at rest whose shapes are known: the operators are integrated over the
/// shapes, cut cells and surface included, so that area, volume and accuracy do not depend on where
/// the body lies or how its points are filled. Points are only looked at.
///
/// Conduction is explicit (or theta), the surface implicit in either:
///   (C + dt M) dT = dt (-K T + E(T)),  E_I = integral of S_I rate(T) dA.
template <int Dim>
class CutCellHeat final : public Physics,
                          public HasSurface,
                          public Warnings,
                          public FollowsChanges,
                          public TellsStepsAhead {
 public:
  CutCellHeat(Points& points, HeatProblem<Dim> problem);

  /// Whether a problem is of this kind.
  static bool suits(const HeatProblem<Dim>& problem);

  std::string name() const override { return "heat"; }
  void follow_changes(double end, double longest) override;
  StepsAhead steps_ahead() const override;
  StepLimit step_limit() const override;
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
  /// Laws as forms on nodes that lead, and the solver of these.
  struct System {
    std::vector<Index> unknown_place;
    SurfaceTerm surface;
    SurfaceSolver solver;
    SurfaceTerm::Matrix conduction;  // K' of the unknowns; empty where it is taken explicitly
    SurfaceTerm::Vector error;       // K, estimated, of adaptive steps so far
    SurfaceTerm::Vector rate;        // W, at the start of the first of them; empty afterwards
  };

  /// What everything gives a part at one time.
  struct HeatRates {
    std::vector<double> rise;    // K/s, by place, of followers too
    std::vector<double> by_law;  // W
    double by_sources = 0.0;     // W
  };

  /// A part with what its steps need.
  struct Solved {
    HeatPart<Dim> part;
    std::vector<WeakExchange> weak;     // laws that stand in the conduction
    System near;                        // the others, on the nodes near the surface
    std::vector<double> exchange_rate;  // of their slopes, by law, per W/(m^2 K), 1/s
    std::unique_ptr<System> all;        // every law on every node, for implicit steps
    std::vector<double> inverse;        // 1/C', one for followers
    std::vector<double> increment;      // K
    SurfaceSolver solver_of_whole;      // near the surface, of steps that are halved as well
    NodalRange<Dim> range;
    std::vector<double> earlier;  // K/s, of the step before; kept now and then by adaptive steps
    HeatRates rates;              // at the start of the next step in stages; empty: not known
    std::vector<double> error;    // K, estimated, by place, while steps are taken in stages
  };

  void bound_step(const std::vector<double>& rates);
  void connect_surface(std::vector<double>& rates);
  bool is_implicit() const {
    return problem_.settings.time_integration == TimeIntegration::implicit_theta;
  }
  bool is_adaptive() const {
    return problem_.settings.time_integration == TimeIntegration::automatic;
  }

  /// One Euler step; under tables, while it is long beside the time since an entry, one and two
  /// halves, extrapolated (Richardson 1911).
  void step_explicitly(const Step& step);
  double time_since_entry(double time) const;  // of a table, s; infinite where there is no table
  void take_explicit_step(const Step& step);
  void take_extrapolated_step(const Step& step);
  // Its phases, part by part.
  void conduct(Solved& one, const Step& step);
  /// Weak laws at the start of the step, and what their middle changes; heat by law, J.
  void exchange_weakly(Solved& one, const Step& step, std::span<double> heat);
  void centre_weak_exchange(Solved& one, double step, std::span<double> heat);
  void release_sources(Solved& one, const Step& step);
  /// How fast sources heat themselves now, for the size of the next explicit step.
  void find_self_heating(double time);
  void exchange_with_surroundings(Solved& one, const Step& step);
  bool bears_explicitly(const Solved& one, double step) const;
  void finish(Solved& one) const;
  void finish_step(const Step& step);
  /// Returns whether a node had left it.
  bool keep_in_range(Solved& one) const;

  void number_all_leaders(Solved& one) const;
  void prepare(const Solved& one, System& system, double scale) const;
  class ThetaStep;
  StepReport advance_implicitly(Solved& one, const Step& step);
  // Adaptive steps: explicit ones, some in stages, or TR-BDF2.
  struct Stage;
  struct Attempt;
  void begin_adaptive_steps();
  /// The longest implicit steps that meet changes of functions, s.
  double step_of_functions();
  void choose_steps(const Step& last);
  double next_entry(double time) const;
  double last_jump() const;  // of a table up to now, s
  /// Keep the rates of change of one step, or compare them with those of the step before. `left`:
  /// share of its error that a step has not got rid of.
  void watch_curvature(Solved& one, const Step& step, double left);
  /// Go from the kind of steps so far to that chosen. `last`: size of the last step, s.
  void change_steps(SteppingKind before, double last);
  void begin_implicit_steps(SteppingKind before, double last);
  void begin_stages();
  void end_long_steps();
  StepReport advance_adaptively(const Step& step);
  /// Explicit steps over [begin, begin + size], where implicit ones are refused.
  void cover_explicitly(const Step& step, double begin, double size);
  bool try_all(double begin, double size, std::vector<Attempt>& attempts, double& error);
  /// Their fastest rate, 1/s; 0 where stages do not suit.
  double rate_of_stages() const;
  HeatRates find_rates(Solved& one, std::span<const double> temperature, double time);
  bool try_stages(Solved& one, double begin, double size, Attempt& attempt);
  void commit_stages(double size, std::vector<Attempt>& attempts);
  bool try_implicitly(Solved& one, double begin, double size, Attempt& attempt);
  bool solve_stage(Solved& one, const Stage& stage, SurfaceTerm::Vector& trial, int& iterations);
  SurfaceTerm::Vector rates(Solved& one, const SurfaceTerm::Vector& at, double from, double to,
                            double factor, std::span<double> of_laws, double& of_sources);
  void commit(Solved& one, const Attempt& attempt);
  double largest_error() const;
  /// Of all temperatures so far, and not less than what rounding leaves of them, K.
  double temperature_span() const;
  void save_stepping(Archive& archive) const;
  void load_stepping(const Archive& archive);
  void widen_span();

  /// Enter the heat that laws gave when the surface rose by `rise`; it adds up to `given`.
  void book_laws(const Solved& one, double size, const SurfaceTerm::Vector& rise, double given);

  void require_finite() const;
  static SurfaceTerm::Vector gather(const System& system, std::span<const double> values);
  static void scatter(const System& system, const SurfaceTerm::Vector& some,
                      std::span<double> values);
  /// Whether neither laws nor sources of a part depend on the temperature but linearly.
  bool is_linear(const Solved& one) const;

  Points& points_;
  HeatProblem<Dim> problem_;
  HeatCoefficients<Dim> coefficients_;
  SurfaceConditions laws_;
  StepLimit limit_;
  std::vector<SurfaceFound> found_;
  std::vector<Solved> solved_;
  std::vector<std::size_t> part_of_;     // by body
  double initial_ = 0.0, source_ = 0.0;  // J
  SelfHeating self_heating_;
  double time_ = 0.0;  // s, of the temperatures

  AdaptiveSteps adaptive_;
  double end_ = std::numeric_limits<double>::infinity();  // s, of the run, where known
  double lowest_ = 0.0, highest_ = 0.0;  // K, of all temperatures so far, for adaptive steps
  double explicit_error_ = 0.0;          // K, estimated
  Index implicit_steps_ = 0, staged_steps_ = 0;
  double factor_size_ = 0.0;  // s, of the implicit step that the factor belongs to
  double bend_ = 0.0;         // K/s^2, largest change of rates over the last step in stages
  // Steps in stages that only calm what is left of the explicit ones, which take the surface a
  // little differently.
  Index calming_ = 0;

  TemperatureRange range_;  // that conduction and exchange can reach
  std::unique_ptr<PointArray> output_temperature_, output_flux_;  // made when first looked at
};

}  // namespace lapilli
