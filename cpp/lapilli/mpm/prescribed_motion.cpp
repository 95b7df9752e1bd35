#include "lapilli/mpm/prescribed_motion.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

template <int Dim>
Vec<Dim> vector_of(const std::vector<double>& values, const char* what) {
  require(values.size() == static_cast<std::size_t>(Dim), what, " needs ", Dim, " numbers, got ",
          values.size());
  return Eigen::Map<const Vec<Dim>>(values.data());
}

template <int Dim>
Mat<Dim> rotation_by(double angle, const std::vector<double>& axis) {
  if constexpr (Dim == 2) {
    return Eigen::Rotation2Dd(angle).toRotationMatrix();
  } else if constexpr (Dim == 3) {
    return Eigen::AngleAxisd(angle, vector_of<3>(axis, "motion.axis").normalized())
        .toRotationMatrix();
  } else {
    return Mat<Dim>::Identity();
  }
}

/// Where a point that started at `start` is at `time`, and the gradient of that map.
template <int Dim>
struct Placed {
  Vec<Dim> position;
  Mat<Dim> deformation;
};

template <int Dim>
Placed<Dim> placed(const Rotation& motion, const Vec<Dim>& start, double time) {
  const Vec<Dim> center = vector_of<Dim>(motion.center, "motion.center");
  const Mat<Dim> turn =
      rotation_by<Dim>(full_turn * motion.revolutions_per_second * time, motion.axis);
  return {center + turn * (start - center), turn};
}

template <int Dim>
Placed<Dim> placed(const Translation& motion, const Vec<Dim>& start, double time) {
  return {start + time * vector_of<Dim>(motion.velocity, "motion.velocity"),
          Mat<Dim>::Identity()};
}

template <int Dim>
Placed<Dim> placed(const Swirl& motion, const Vec<Dim>& start, double time) {
  if constexpr (Dim == 2) {
    const Vec<2> center = vector_of<2>(motion.center, "motion.center");
    const Vec<2> away = start - center;
    const double rate = full_turn * motion.revolutions_per_second;
    const double share = away.squaredNorm() / (motion.radius * motion.radius);
    const double angle = rate * (1.0 + motion.shear * (1.0 - share)) * time;
    const Mat<2> turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
    // d(turn away)/d away = turn + (d turn/d angle) away (d angle/d away)^T
    const Vec<2> slope = -2.0 * rate * motion.shear * time / (motion.radius * motion.radius) * away;
    const Mat<2> quarter = Eigen::Rotation2Dd(0.5 * std::numbers::pi).toRotationMatrix();
    return {center + turn * away, turn + quarter * turn * away * slope.transpose()};
  } else {
    return {start, Mat<Dim>::Identity()};
  }
}

}  // namespace

template <int Dim>
PrescribedMotion<Dim>::PrescribedMotion(Points& points,
                                        std::vector<std::optional<Motion>> motions)
    : points_(points), motions_(std::move(motions)), start_(points, Dim) {
  for (std::size_t body = 0; body < motions_.size(); ++body) {
    if (!motions_[body]) {
      continue;
    }
    require(Dim > 1 || std::holds_alternative<Translation>(*motions_[body]), "bodies.", body,
            ".motion: a line of points can only be translated");
    require(Dim == 2 || !std::holds_alternative<Swirl>(*motions_[body]), "bodies.", body,
            ".motion: a swirl needs two dimensions");
    std::visit([](const auto& motion) { placed<Dim>(motion, Vec<Dim>::Zero(), 0.0); },
               *motions_[body]);
  }
  std::copy(points.position().begin(), points.position().end(), start_.data());
}

template <int Dim>
StepLimit PrescribedMotion<Dim>::step_limit() const {
  StepLimit limit;
  limit.reason = "prescribed motion has no limit";
  return limit;
}

template <int Dim>
StepReport PrescribedMotion<Dim>::advance(const Step& step) {
  const double before = step.time, after = step.time + step.size;
  const auto place = [this](Index row, double time) {
    const Vec<Dim> start = Eigen::Map<const Vec<Dim>>(start_.data() + row * Dim);
    const auto& motion = motions_[points_.body()[row]];
    return motion ? std::visit([&](const auto& m) { return placed<Dim>(m, start, time); }, *motion)
                  : Placed<Dim>{start, Mat<Dim>::Identity()};
  };
  parallel_for(points_.size(), [&](Index row) {
    Eigen::Map<Vec<Dim>>(points_.position().data() + row * Dim) = place(row, after).position;
  });
  points_.moved<Dim>([&](Index row) -> Mat<Dim> {
    return place(row, after).deformation * place(row, before).deformation.inverse();
  });
  return {step.size, 0, 0.0};
}

template <int Dim>
void PrescribedMotion<Dim>::save(Archive& archive) const {
  archive.write("motion/start", start_.values());
}

template <int Dim>
void PrescribedMotion<Dim>::load(const Archive& archive) {
  archive.read("motion/start", start_.values());
}

template class PrescribedMotion<1>;
template class PrescribedMotion<2>;
template class PrescribedMotion<3>;

}  // namespace lapilli
