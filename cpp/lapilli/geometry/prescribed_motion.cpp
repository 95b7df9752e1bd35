#include "lapilli/geometry/prescribed_motion.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

template <int Dim>
Vec<Dim> vector_of(const std::vector<double>& values, const char* what) {
  if (values.empty()) {
    return Vec<Dim>::Zero();
  }
  require(values.size() == static_cast<std::size_t>(Dim), what, " needs ", Dim, " numbers, got ",
          values.size());
  return Eigen::Map<const Vec<Dim>>(values.data());
}

/// Where a point that started at `start` is now, and the gradient of that map.
template <int Dim>
struct Placed {
  Vec<Dim> position;
  Mat<Dim> deformation;
};

/// A motion at one time, ready to place points.
template <int Dim>
struct RigidMap {
  Mat<Dim> turn = Mat<Dim>::Identity();
  Vec<Dim> centre = Vec<Dim>::Zero(), shift = Vec<Dim>::Zero();

  Placed<Dim> operator()(const Vec<Dim>& start) const {
    return {centre + turn * (start - centre) + shift, turn};
  }
};

template <int Dim>
struct SwirlMap {
  Vec<Dim> centre = Vec<Dim>::Zero();
  double angle = 0.0, shear = 0.0, radius = 1.0;  // of the rim

  Placed<Dim> operator()(const Vec<Dim>& start) const {
    if constexpr (Dim == 2) {
      const Vec<2> away = start - centre;
      const double share = away.squaredNorm() / (radius * radius);
      const Mat<2> turn =
          Eigen::Rotation2Dd(angle * (1.0 + shear * (1.0 - share))).toRotationMatrix();
      // d(turn away)/d away = turn + (d turn/d angle) away (d angle/d away)^T
      const Vec<2> slope = -2.0 * angle * shear / (radius * radius) * away;
      const Vec<2> turned = turn * away;
      return {centre + turned, turn + Vec<2>(-turned[1], turned[0]) * slope.transpose()};
    } else {
      return {start, Mat<Dim>::Identity()};
    }
  }
};

template <int Dim>
using PlaceMap = std::variant<RigidMap<Dim>, SwirlMap<Dim>>;

template <int Dim>
PlaceMap<Dim> map_at(const Rotation& motion, double time) {
  RigidMap<Dim> map;
  map.centre = vector_of<Dim>(motion.center, "motion.center");
  const double angle = full_turn * motion.revolutions_per_second * time;
  if constexpr (Dim == 2) {
    map.turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  } else if constexpr (Dim == 3) {
    const Vec<3> axis = vector_of<3>(motion.axis, "motion.axis");
    require(axis.norm() > 0.0, "motion.axis must have a length");
    map.turn = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  }
  return map;
}

template <int Dim>
PlaceMap<Dim> map_at(const Translation& motion, double time) {
  RigidMap<Dim> map;
  map.shift = time * vector_of<Dim>(motion.velocity, "motion.velocity");
  return map;
}

template <int Dim>
PlaceMap<Dim> map_at(const Swirl& motion, double time) {
  return SwirlMap<Dim>{vector_of<Dim>(motion.center, "motion.center"),
                       full_turn * motion.revolutions_per_second * time, motion.shear,
                       motion.radius};
}

template <int Dim>
std::vector<PlaceMap<Dim>> maps_at(const std::vector<std::optional<Motion>>& motions, double time) {
  std::vector<PlaceMap<Dim>> maps;
  for (const auto& motion : motions) {
    maps.push_back(motion ? std::visit([&](const auto& m) { return map_at<Dim>(m, time); }, *motion)
                          : PlaceMap<Dim>(RigidMap<Dim>{}));
  }
  return maps;
}

/// Turn what points carry as gradients from their places at one time to those at another.
template <int Dim>
void carry_gradients(Points& points, const PointArray& start,
                     const std::vector<PlaceMap<Dim>>& before,
                     const std::vector<PlaceMap<Dim>>& after) {
  // The same for all points of a rigid body; nothing at all where no body turns.
  std::vector<std::optional<Mat<Dim>>> of_body(after.size());
  bool turns = false;
  for (std::size_t body = 0; body < after.size(); ++body) {
    if (const auto* rigid = std::get_if<RigidMap<Dim>>(&after[body])) {
      of_body[body] = rigid->turn * std::get<RigidMap<Dim>>(before[body]).turn.transpose();
    }
    turns = turns || !of_body[body] || !of_body[body]->isIdentity(0.0);
  }
  if (!turns) {
    points.moved();
    return;
  }
  points.moved<Dim>([&](Index row) -> Mat<Dim> {
    const Index body = points.body()[row];
    if (of_body[body]) {
      return *of_body[body];
    }
    const Vec<Dim> from = Eigen::Map<const Vec<Dim>>(start.data() + row * Dim);
    const auto at = [&](const std::vector<PlaceMap<Dim>>& maps) {
      return std::get<SwirlMap<Dim>>(maps[body])(from).deformation;
    };
    return at(after) * at(before).inverse();
  });
}

}  // namespace

template <int Dim>
PrescribedMotion<Dim>::PrescribedMotion(Points& points, std::vector<std::optional<Motion>> motions,
                                        bool lazy)
    : points_(points), motions_(std::move(motions)), start_(points, Dim), lazy_(lazy) {
  for (std::size_t body = 0; body < motions_.size(); ++body) {
    if (!motions_[body]) {
      continue;
    }
    require(Dim > 1 || std::holds_alternative<Translation>(*motions_[body]), "bodies.", body,
            ".motion: a line of points can only be translated");
    require(Dim == 2 || !std::holds_alternative<Swirl>(*motions_[body]), "bodies.", body,
            ".motion: a swirl needs two dimensions");
  }
  maps_at<Dim>(motions_, 0.0);  // refuses what the dimension does not allow
  std::copy(points.position().begin(), points.position().end(), start_.data());
}

template <int Dim>
StepLimit PrescribedMotion<Dim>::step_limit() const {
  StepLimit limit;
  limit.reason = "prescribed motion has no limit";
  return limit;
}

template <int Dim>
template <class Body>
void PrescribedMotion<Dim>::for_each_run(const Body& body) const {
  const std::span<const Index> body_of = points_.body();
  parallel_ranges(points_.size(), [&](Index begin, Index end) {
    while (begin < end) {
      Index last = begin + 1;
      while (last < end && body_of[last] == body_of[begin]) {
        ++last;
      }
      body(body_of[begin], begin, last);
      begin = last;
    }
  });
}

template <int Dim>
StepReport PrescribedMotion<Dim>::advance(const Step& step) {
  time_ = step.time + step.size;
  if (!lazy_ || step.output_due) {
    move(lazy_ ? placed_ : step.time, time_);
  }
  return {step.size, 0, 0.0};
}

template <int Dim>
void PrescribedMotion<Dim>::refresh_output() {
  if (placed_ != time_) {
    move(placed_, time_);
  }
}

template <int Dim>
void PrescribedMotion<Dim>::move(double from, double to) {
  const auto before = maps_at<Dim>(motions_, from);
  const auto after = maps_at<Dim>(motions_, to);
  const auto start = [this](Index row) {
    return Vec<Dim>(Eigen::Map<const Vec<Dim>>(start_.data() + row * Dim));
  };
  for_each_run([&](Index body, Index begin, Index end) {
    std::visit(
        [&](const auto& map) {
          for (Index row = begin; row < end; ++row) {
            Eigen::Map<Vec<Dim>>(points_.position().data() + row * Dim) = map(start(row)).position;
          }
        },
        after[body]);
  });
  carry_gradients<Dim>(points_, start_, before, after);
  placed_ = to;
}

template <int Dim>
void PrescribedMotion<Dim>::save(Archive& archive) const {
  archive.write("motion/start", start_.values());
  archive.write("motion/times", std::array{time_, placed_});
}

template <int Dim>
void PrescribedMotion<Dim>::load(const Archive& archive) {
  archive.read("motion/start", start_.values());
  std::array<double, 2> times{};
  archive.read("motion/times", std::span<double>(times));
  time_ = times[0];
  placed_ = times[1];
}

template class PrescribedMotion<1>;
template class PrescribedMotion<2>;
template class PrescribedMotion<3>;

}  // namespace lapilli
