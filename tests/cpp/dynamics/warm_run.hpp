#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lapilli/core/parallel.hpp"
#include "lapilli/geometry/combine.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/geometry/join_small.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"
#include "lapilli/mpm/heat/particle_heat.hpp"

/// Heat and motion of bodies together, built the way a scene would.
namespace dynamics_test {

using namespace lapilli;

constexpr double perfect = std::numeric_limits<double>::infinity();

/// A box turned about the origin.
inline Shape turned_box(Vec<2> lower, Vec<2> upper, double degrees) {
  Rotated turned;
  turned.shape = Nested(Shape(Box{{lower[0], lower[1]}, {upper[0], upper[1]}}));
  turned.degrees = degrees;
  turned.center = {0.0, 0.0};
  return turned;
}

/// A body of density, heat capacity and thickness 1.
struct WarmBody {
  Shape shape;
  double temperature = 1.0, conductivity = 1.0;  // K, W/(m K)
};

struct WarmRun {
  WarmRun(double cell, double reach, const std::vector<WarmBody>& bodies,
          const std::vector<Obstacle>& obstacles, std::vector<double> gravity = {},
          double young = 100.0, const std::vector<HeatContact>& contacts = {}, double damping = 0.0,
          int threads = 1, ContactKind meet = ContactKind::frictional,
          const std::vector<HeatBoundary>& boundaries = {})
      : grid({-reach, -reach}, {reach, reach}, cell), points(2) {
    set_thread_count(threads);
    DynamicsProblem<2> motion{grid, ShapeFunction::gimp, {}, {}};
    HeatProblem<2> conduction{grid, ShapeFunction::gimp, {}, {}, {}, true};
    conduction.settings.contacts = contacts;
    conduction.settings.boundaries = boundaries;
    conduction.separates = true;
    Lattice lattice;
    lattice.lower = Vec3(-reach, -reach, 0.0);
    lattice.cell = cell;
    FillOptions options;
    options.clip = true;
    for (const WarmBody& body : bodies) {
      check(body.shape, 2);
      FilledPoints filled = fill(body.shape, lattice, options, 2);
      join_small(filled, 0.5);
      const auto number = static_cast<int>(motion.bodies.size());
      points.append(filled.position, filled.volume, number);
      DynamicsBody solid{LinearElastic{1.0, young, 0.3}, 0.25, {}, {}};
      solid.name = message("body ", number);
      solid.spacing = filled.spacing;
      motion.bodies.push_back(solid);
      motion.bodies.back().shape = body.shape;
      Thermal thermal;
      thermal.density = 1.0;
      thermal.specific_heat = 1.0;
      thermal.conductivity = SymmetricTensor(body.conductivity);
      conduction.bodies.push_back({thermal, 0.25, body.temperature, 0.0, body.shape, solid.name});
    }
    motion.settings.obstacles = obstacles;
    motion.settings.gravity = std::move(gravity);
    motion.settings.local_damping = damping;
    if (bodies.size() > 1) {
      motion.settings.contacts = {BodyContact{{}, meet}};
    }
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      check(obstacles[k], 2, static_cast<int>(k));
      conduction.obstacles.push_back({obstacles[k].name, static_cast<int>(k),
                                      obstacles[k].temperature, obstacles[k].conductance,
                                      obstacles[k].heat_capacity});
    }
    heat = std::make_unique<ParticleHeat<2>>(points, conduction);
    dynamics = make_dynamics<2>(points, motion);
    heat->follow({[this] { return dynamics->speed(); },
                  [this] { return dynamics->step_limit().automatic; }});
    if (dynamics->has_contacts()) {
      heat->separate(dynamics->node_fields(), dynamics->touches());
    }
    std::vector<FindFeet<2>> feet;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      feet.push_back([this, k] { return dynamics->feet(k); });
    }
    heat->touch(std::move(feet));
    dynamics->turn(*heat->carried_gradient());
  }

  /// Steps of one size, the automatic one at the most.
  void until(double end) {
    while (time < end * (1.0 - 1e-12)) {
      const double most = std::min(heat->step_limit().automatic, dynamics->step_limit().automatic);
      const double left = end - time, size = left / std::ceil(left / most * (1.0 - 1e-9));
      const bool last = time + size >= end * (1.0 - 1e-12);
      const Step step{time, size, index++, last, last};
      heat->advance(step);
      dynamics->advance(step);
      time += size;
    }
  }

  Balance balance() const { return heat->balances().front(); }
  double of_heat(const std::string& name) const { return find(heat->diagnostics(), name); }
  double of_motion(const std::string& name) const { return find(dynamics->diagnostics(), name); }
  /// Mean over the points of a body of what they carry, K.
  double carried(Index body) const {
    double sum = 0.0, volume = 0.0;
    for (Index row = 0; row < points.size(); ++row) {
      if (std::as_const(points).body()[row] == body) {
        const double here = std::as_const(points).volume()[row];
        sum += here * heat->carried_temperature()[row];
        volume += here;
      }
    }
    return sum / volume;
  }
  /// The mean place of all points, m.
  Vec<2> middle() const {
    Vec<2> sum = Vec<2>::Zero();
    for (Index row = 0; row < points.size(); ++row) {
      sum += points.position<2>(row);
    }
    return sum / static_cast<double>(points.size());
  }
  /// Least and largest temperature that is shown.
  std::pair<double, double> range() const {
    const auto values = heat->fields().front().values;
    const auto [least, most] = std::ranges::minmax_element(values);
    return {*least, *most};
  }

  Grid<2> grid;
  Points points;
  std::unique_ptr<ParticleHeat<2>> heat;
  std::unique_ptr<Dynamics<2>> dynamics;
  double time = 0.0;
  Index index = 0;

 private:
  static double find(const std::vector<std::pair<std::string, double>>& all,
                     const std::string& name) {
    for (const auto& [known, value] : all) {
      if (known == name) {
        return value;
      }
    }
    throw std::invalid_argument(name);
  }
};

/// What `make(threads)` makes has the same temperatures after two spans of .01 s with 1, 2 and 3
/// threads, and from what is saved after the first of them.
template <class Make>
void check_same_bytes_of_heat(const Make& make) {
  const auto bytes_of = [](const WarmRun& run) {
    Archive archive;
    run.heat->save(archive);
    return archive.read_numbers("heat/temperature");
  };
  std::vector<std::vector<double>> all;
  for (const int threads : {1, 2, 3}) {
    auto run = make(threads);
    run->until(0.01);
    run->until(0.02);
    all.push_back(bytes_of(*run));
  }
  CHECK(all[1] == all[0]);
  CHECK(all[2] == all[0]);
  auto first = make(1);
  first->until(0.01);
  Archive archive;
  first->points.save(archive);
  first->heat->save(archive);
  first->dynamics->save(archive);
  auto second = make(1);
  second->points.load(archive);
  second->heat->load(archive);
  second->dynamics->load(archive);
  second->time = first->time;
  second->index = first->index;
  second->until(0.02);
  CHECK(bytes_of(*second) == all[0]);
}

}  // namespace dynamics_test
