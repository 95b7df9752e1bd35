#include "lapilli/mpm/heat/heat_in_body_frame.hpp"

#include <algorithm>

#include "lapilli/core/parallel.hpp"
#include "lapilli/mpm/heat/functions_in_time.hpp"

namespace lapilli {
namespace {

/// A function of the place in space as one of the place in the frame of the bodies.
Value in_frame(const Value& value, const Motion& motion, int dimension) {
  const auto* function = std::get_if<ArrayFunction>(&value.form());
  if (function == nullptr) {
    return value;
  }
  return ArrayFunction([ask = *function, motion, dimension](std::span<const Vec3> position,
                                                            std::span<const double> state,
                                                            double time, std::span<double> values) {
    const Placement now = placement_at(motion, time, dimension);
    std::vector<Vec3> moved(position.begin(), position.end());
    for (Vec3& at : moved) {
      at = now(at);
    }
    ask(moved, state, time, values);
  });
}

template <int Dim>
HeatProblem<Dim> problem_in_frame(HeatProblem<Dim> problem, const Motion& motion) {
  for (HeatBoundary& law : problem.settings.boundaries) {
    for (Value* value : values_of(law)) {
      *value = in_frame(*value, motion, Dim);
    }
  }
  for (HeatBody& body : problem.bodies) {
    body.source = in_frame(body.source, motion, Dim);
  }
  problem.moving = false;
  problem.frame.reset();
  return problem;
}

}  // namespace

bool bears_body_frame(const HeatSettings& settings, const std::optional<Motion>& motion,
                      int dimension) {
  return motion && is_rigid(*motion) && settings.method == FluxMethod::virtual_flux &&
         (settings.transfer == HeatTransfer::automatic ||
          settings.transfer == HeatTransfer::nodal) &&
         std::all_of(settings.boundaries.begin(), settings.boundaries.end(),
                     [&](const HeatBoundary& law) {
                       const Shape* region = region_of(law);
                       return region == nullptr || carries_into_itself(*motion, *region, dimension);
                     });
}

template <int Dim>
bool HeatInBodyFrame<Dim>::suits(const HeatProblem<Dim>& problem) {
  return bears_body_frame(problem.settings, problem.frame, Dim);
}

template <int Dim>
HeatInBodyFrame<Dim>::HeatInBodyFrame(Points& points, HeatProblem<Dim> problem)
    : points_(points),
      motion_(*problem.frame),
      depends_on_place_(has_functions(problem)),
      at_rest_(make_heat<Dim>(points, problem_in_frame(std::move(problem), motion_))),
      start_(std::make_unique<PointArray>(points, Dim)) {
  std::copy(points.position().begin(), points.position().end(), start_->data());
}

template <int Dim>
void HeatInBodyFrame<Dim>::follow_changes(double end, double longest) {
  if (auto* follower = dynamic_cast<FollowsChanges*>(at_rest_.get())) {
    follower->follow_changes(end, longest);
  }
}

template <int Dim>
StepsAhead HeatInBodyFrame<Dim>::steps_ahead() const {
  const auto* teller = dynamic_cast<const TellsStepsAhead*>(at_rest_.get());
  return teller != nullptr ? teller->steps_ahead() : StepsAhead{};
}

template <int Dim>
StepReport HeatInBodyFrame<Dim>::advance(const Step& step) {
  const StepReport report = at_rest_->advance(step);
  time_ = step.time + report.accepted;
  return report;
}

template <int Dim>
void HeatInBodyFrame<Dim>::refresh_output() {
  // The solver at rest looks at the points where they were at the start.
  const std::vector<double> now(points_.position().begin(), points_.position().end());
  std::copy(start_->values().begin(), start_->values().end(), points_.position().begin());
  at_rest_->refresh_output();
  std::vector<Field> fields = at_rest_->fields();
  std::copy(now.begin(), now.end(), points_.position().begin());
  shown_ = true;
  const Mat<Dim> turn = placement_at(motion_, time_, Dim).turn.template topLeftCorner<Dim, Dim>();
  for (const Field& field : fields) {
    if (field.name == "heat_flux") {
      parallel_for(points_.size(), [&](Index row) {
        Eigen::Map<Vec<Dim>> flux(field.values.data() + row * Dim);
        flux = Vec<Dim>(turn * flux);
      });
    }
  }
}

template <int Dim>
std::vector<Field> HeatInBodyFrame<Dim>::fields() {
  if (!shown_) {
    refresh_output();
  }
  return at_rest_->fields();
}

template <int Dim>
SurfaceView HeatInBodyFrame<Dim>::surface() const {
  SurfaceView view = dynamic_cast<const HasSurface&>(*at_rest_).surface();
  const Placement now = placement_at(motion_, time_, Dim);
  for (std::size_t k = 0; k < view.area.size(); ++k) {
    Vec3 at = Vec3::Zero(), normal = Vec3::Zero();
    std::copy_n(view.position.data() + k * Dim, Dim, at.data());
    std::copy_n(view.normal.data() + k * Dim, Dim, normal.data());
    at = now(at);
    normal = Vec3(now.turn * normal);
    std::copy_n(at.data(), Dim, view.position.data() + k * Dim);
    std::copy_n(normal.data(), Dim, view.normal.data() + k * Dim);
  }
  return view;
}

template <int Dim>
std::vector<Note> HeatInBodyFrame<Dim>::warnings() const {
  return warnings_of(*at_rest_);
}

template <int Dim>
void HeatInBodyFrame<Dim>::save(Archive& archive) const {
  at_rest_->save(archive);
  archive.write("heat/frame/start", std::as_const(*start_).values());
  archive.write("heat/frame/time", time_);
}

template <int Dim>
void HeatInBodyFrame<Dim>::load(const Archive& archive) {
  at_rest_->load(archive);
  archive.read("heat/frame/start", start_->values());
  time_ = archive.read_number("heat/frame/time");
  shown_ = false;
}

template class HeatInBodyFrame<1>;
template class HeatInBodyFrame<2>;
template class HeatInBodyFrame<3>;

}  // namespace lapilli
