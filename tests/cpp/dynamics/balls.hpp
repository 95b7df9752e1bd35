#pragma once

#include <cmath>
#include <numbers>

#include "dynamics/fixtures.hpp"

/// Two elastic balls that meet, and balls of exact volume to build others from.
namespace dynamics_test {

inline constexpr double density = 1000.0, young = 1e6, poisson = 0.3;
inline const double wave =
    std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / density);

/// A ball of `radius`: boxes of half a cell, each with the volume and centroid of its part.
template <int Dim>
void fill_ball(Run<Dim>& run, const Vec<Dim>& center, double radius, DynamicsBody body) {
  constexpr int parts = Dim == 2 ? 12 : 5;
  constexpr double spacing = 0.5;
  const int across = static_cast<int>(2 * radius / spacing) + 2;
  const Vec<Dim> corner = (center.array() / spacing - 0.5 * across).round().matrix() * spacing;
  std::vector<double> positions, volumes;
  const auto digits = [](Index k, int base, double shift) {
    Vec<Dim> place;
    for (int axis = 0; axis < Dim; ++axis) {
      place[axis] = static_cast<double>(k % base) + shift;
      k /= base;
    }
    return place;
  };
  const auto boxes = static_cast<Index>(std::pow(across, Dim));
  const auto pieces = static_cast<Index>(std::pow(parts, Dim));
  for (Index box = 0; box < boxes; ++box) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    int count = 0;
    for (Index piece = 0; piece < pieces; ++piece) {
      const Vec<Dim> x =
          corner + spacing * (digits(box, across, 0.0) + digits(piece, parts, 0.5) / parts);
      if ((x - center).norm() < radius) {
        sum += x;
        ++count;
      }
    }
    if (count > 0) {
      sum /= count;
      positions.insert(positions.end(), sum.data(), sum.data() + Dim);
      volumes.push_back(std::pow(spacing, Dim) * count / static_cast<double>(pieces));
    }
  }
  body.half_width = 0.25;
  run.points.append(positions, volumes, static_cast<int>(run.problem.bodies.size()));
  run.problem.bodies.push_back(std::move(body));
}

template <int Dim>
DynamicsBody moving(const Vec<Dim>& velocity, const char* name) {
  Vec3 full = Vec3::Zero();
  full.template head<Dim>() = velocity;
  DynamicsBody body{elastic(density, young, poisson), 0.25, [=](const Vec3&) { return full; }, {}};
  body.name = name;
  return body;
}

/// What a meeting of two balls is made of.
struct Meeting {
  double radius = 5.0, speed = 0.02, degrees = 0.0, gap = 1.0, aside = 0.0, friction = 0.0;
  bool wall = false;  // one ball and the slippery face x = 0 of the grid
  Vec3 offset{0.13, 0.29, 0.17}, frame = Vec3::Zero();
  VelocityTransfer transfer = VelocityTransfer::blended_apic;
  ShapeFunction shape = ShapeFunction::gimp;
  StressUpdate update = StressUpdate::musl;
};

template <int Dim>
struct Balls {
  explicit Balls(const Meeting& m)
      : meeting(m), run(room(m), m.shape), end(2 * m.gap / m.speed / wave + 9 * m.radius / wave) {
    const double angle = m.degrees * std::numbers::pi / 180;
    along = Vec<Dim>::Zero();
    along.template head<2>() << std::cos(angle), std::sin(angle);
    across = Vec<Dim>::Zero();
    across.template head<2>() << -std::sin(angle), std::cos(angle);
    const double v = m.speed * wave;
    const Vec<Dim> frame = v * m.frame.head<Dim>();
    for (int side : {-1, 1}) {
      if (m.wall && side > 0) {
        run.frictional(0, 1, 0.0);
        break;
      }
      const Vec<Dim> center = m.offset.head<Dim>() + side * (m.radius + m.gap / 2) * along +
                              0.5 * side * m.aside * across;
      fill_ball<Dim>(run, center, m.radius,
                     moving<Dim>(frame - side * v * along, side < 0 ? "left" : "right"));
    }
    if (!m.wall) {
      run.problem.settings.contacts = {{{}, ContactKind::frictional, m.friction, 0.0}};
    }
    run.problem.settings.transfer = m.transfer;
    run.problem.settings.stress_update = m.update;
  }

  static Grid<Dim> room(const Meeting& m) {
    const double far = std::ceil(2 * m.radius + 5 + 0.3 * m.frame.norm() * m.radius);
    Vec<Dim> upper = Vec<Dim>::Constant(far);
    upper[0] = m.wall ? 0.0 : far;
    return Grid<Dim>(Vec<Dim>::Constant(-far), upper, 1.0);
  }

  void meet(int threads = 1) {
    run.start(threads);
    begin = momentum();
    run.until(end);
  }
  Vec<Dim> momentum(int body = -1) const {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (Index row = 0; row < run.points.size(); ++row) {
      if (body < 0 || run.points.body()[row] == body) {
        sum += run.solver->mass()[row] *
               Eigen::Map<const Vec<Dim>>(run.solver->velocity().data() + row * Dim);
      }
    }
    return sum;
  }
  double mass(int body) const {
    double sum = 0.0;
    for (Index row = 0; row < run.points.size(); ++row) {
      sum += run.points.body()[row] == body ? run.solver->mass()[row] : 0.0;
    }
    return sum;
  }
  /// Velocity of the left ball over its speed before, along and across, in the frame of the draw.
  Vec<2> rebound() const {
    const Vec<Dim> v = momentum(0) / mass(0) / (meeting.speed * wave) - meeting.frame.head<Dim>();
    return {v.dot(along), v.dot(across)};
  }

  Meeting meeting;
  Run<Dim> run;
  double end;
  Vec<Dim> along, across, begin;
};

/// Share of the energy of the fall that a ball has after it.
template <int Dim>
double returned(const Meeting& meeting) {
  Balls<Dim> balls(meeting);
  balls.meet();
  return balls.rebound().squaredNorm();
}

}  // namespace dynamics_test
