#pragma once

#include <memory>

#include "lapilli/core/warnings.hpp"
#include "lapilli/geometry/rigid_motion.hpp"
#include "lapilli/mpm/heat/follows_changes.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/heat/steps_ahead.hpp"
#include "lapilli/mpm/surface/surface_view.hpp"

namespace lapilli {

/// Whether heat under these settings is solved in the frame of bodies that share this motion: a
/// rigid one, no choice that asks for moving points, and regions in space, if any, that the motion
/// maps onto themselves.
bool bears_body_frame(const HeatSettings& settings, const std::optional<Motion>& motion,
                      int dimension);

/// Heat of bodies that one rigid motion moves, solved in their own frame: heat does not know that
/// they move, so the solver is that of bodies at rest, on a grid fixed to them. Only conditions do
/// that depend on the place: these are asked where it has come to.
template <int Dim>
class HeatInBodyFrame final : public Physics,
                              public HasSurface,
                              public Warnings,
                              public FollowsChanges,
                              public TellsStepsAhead {
 public:
  /// Whether a problem is of this kind.
  static bool suits(const HeatProblem<Dim>& problem);

  HeatInBodyFrame(Points& points, HeatProblem<Dim> problem);

  std::string name() const override { return "heat"; }
  /// Whether conditions depend on where the bodies are: functions, which may.
  bool depends_on_place() const { return depends_on_place_; }

  void follow_changes(double end, double longest) override;
  StepsAhead steps_ahead() const override;
  StepLimit step_limit() const override { return at_rest_->step_limit(); }
  StepReport advance(const Step& step) override;
  void refresh_output() override;
  std::vector<Field> fields() override;
  std::vector<Balance> balances() const override { return at_rest_->balances(); }
  std::vector<std::pair<std::string, double>> diagnostics() const override {
    return at_rest_->diagnostics();
  }
  SurfaceView surface() const override;
  std::vector<Note> warnings() const override;
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;

 private:
  Points& points_;
  Motion motion_;
  bool depends_on_place_;
  std::unique_ptr<Physics> at_rest_;
  std::unique_ptr<PointArray> start_;  // m, places in the frame of the bodies
  double time_ = 0.0;                  // s
  bool shown_ = false;
};

}  // namespace lapilli
