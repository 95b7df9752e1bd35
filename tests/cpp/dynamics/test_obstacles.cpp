// Rigid obstacles that do not fit the grid.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "dynamics/same_bytes.hpp"
#include "lapilli/core/require.hpp"

using namespace dynamics_test;

namespace {

constexpr double g = 10.0, density = 2000.0;

/// An elastic block of 8 by 4 cells of 1 m (or `layers` of .5 m) on a plane turned by `degrees`, in
/// the stress of its weight across the plane. The plane passes through a place that fits no node.
struct Turned {
  explicit Turned(double degrees)
      : angle(degrees * std::numbers::pi / 180),
        along(std::cos(angle), std::sin(angle)),
        normal(-std::sin(angle), std::cos(angle)) {}

  double angle;
  Vec<2> along, normal;
  Vec<2> origin{0.37, 0.21};
};

std::unique_ptr<Run<2>> block(const Turned& plane, Obstacle obstacle, double gap = 0.0,
                              const std::function<Vec3(const Vec3&)>& velocity = {},
                              int layers = 8) {
  auto run = std::make_unique<Run<2>>(Grid<2>({-20, -20}, {20, 20}, 1.0), ShapeFunction::gimp);
  std::vector<double> positions, volumes;
  for (int i = 0; i < 16; ++i) {
    for (int j = 0; j < layers; ++j) {
      const Vec<2> x = plane.origin + (0.5 * (i + 0.5) - 4.0) * plane.along +
                       (0.5 * (j + 0.5) + gap) * plane.normal;
      positions.insert(positions.end(), x.data(), x.data() + 2);
      volumes.push_back(0.25);
    }
  }
  run->points.append(positions, volumes, 0);
  run->problem.bodies.push_back(
      {elastic(density, 1e7, 0.3), 0.25, velocity, [=](const Vec3& x) {
         const double depth = 0.5 * layers - (x.head<2>() - plane.origin).dot(plane.normal);
         const double across = gap > 0.0 ? 0.0 : -density * g * depth;
         const Vec<2> n = plane.normal;
         return SymmetricTensor(across * n[0] * n[0], across * n[1] * n[1], 0, across * n[0] * n[1],
                                0, 0);
       }});
  obstacle.shape =
      HalfSpace{{plane.origin[0], plane.origin[1]}, {plane.normal[0], plane.normal[1]}};
  obstacle.name = "plane";
  run->problem.settings.obstacles = {obstacle};
  return run;
}

Obstacle rough(double friction) {
  Obstacle obstacle;
  obstacle.contact = ObstacleContact::frictional;
  obstacle.friction = friction;
  return obstacle;
}

Vec<2> mean_velocity(const Run<2>& run) {
  Vec<2> sum = Vec<2>::Zero();
  for (Index row = 0; row < run.points.size(); ++row) {
    sum += Eigen::Map<const Vec<2>>(run.solver->velocity().data() + 2 * row);
  }
  return sum / static_cast<double>(run.points.size());
}

double deepest(const Run<2>& run, const Turned& plane) {
  double depth = -1e300;
  for (Index row = 0; row < run.points.size(); ++row) {
    depth = std::max(depth, -(run.points.position<2>(row) - plane.origin).dot(plane.normal));
  }
  return depth;
}

}  // namespace

TEST_CASE("a block rests on a plane at any angle, and its weight with it") {
  for (double degrees : {0.0, 7.0, 23.0, 37.0}) {
    const Turned plane(degrees);
    auto run = block(plane, rough(0.0));
    run->problem.settings.gravity = {-g * plane.normal[0], -g * plane.normal[1]};
    run->start();
    run->until(0.5);
    const double weight = 32 * density * g;
    double sum = 0.0, lowest = 0.0;
    int steps = 0, points = 0;
    for (; steps < 100; ++steps) {
      run->advance(run->automatic_step());
      sum += Vec<2>(run->value("plane force x"), run->value("plane force y")).dot(-plane.normal);
    }
    for (Index row = 0; row < run->points.size(); ++row) {
      const double height = (run->points.position<2>(row) - plane.origin).dot(plane.normal);
      if (height < 0.5) {
        const double* s = run->solver->stress().data() + 4 * row;
        const Vec<2> n = plane.normal;
        lowest -= s[0] * n[0] * n[0] + s[1] * n[1] * n[1] + 2 * s[3] * n[0] * n[1];
        ++points;
      }
    }
    CAPTURE(degrees, sum / steps / weight, deepest(*run, plane), lowest, points);
    CHECK(sum / steps / weight == Approx(1).epsilon(0.003));
    CHECK(std::abs(-deepest(*run, plane) - 0.25) < 0.02);
    CHECK(lowest / points / (density * g * 3.75) == Approx(1).epsilon(0.05));
  }
}

TEST_CASE("a block slides with Coulomb friction at any angle to the grid") {
  for (double degrees : {7.0, 23.0, 37.0}) {
    for (double friction : {0.0, 0.3, 0.6}) {
      const Turned plane(degrees);
      // Lower than long, or it would rock on its leading edge.
      auto run = block(
          plane, rough(friction), 0.0,
          [&](const Vec3&) { return Vec3(4 * plane.along[0], 4 * plane.along[1], 0); }, 4);
      // 35 degrees steeper than the friction of 0.6 holds.
      const double slope = 35 * std::numbers::pi / 180;
      const Vec<2> pull = g * (std::sin(slope) * plane.along - std::cos(slope) * plane.normal);
      run->problem.settings.gravity = {pull[0], pull[1]};
      run->start();
      run->until(0.2);
      const double before = mean_velocity(*run).dot(plane.along), then = run->time;
      run->until(1.0);
      const double found = (mean_velocity(*run).dot(plane.along) - before) / (run->time - then);
      const double exact = g * (std::sin(slope) - friction * std::cos(slope));
      CAPTURE(degrees, friction, found, exact, deepest(*run, plane));
      CHECK(std::abs(found - exact) < 0.002 * g);  // 0.0016; 0.03 where it chatters
      CHECK(deepest(*run, plane) < 0.0);
    }
  }
}

TEST_CASE("a block that friction holds does not creep") {
  for (double safety : {1.0, 0.2}) {
    const Turned plane(23.0);
    auto run = block(plane, rough(0.6));
    const double slope = 20 * std::numbers::pi / 180;
    const Vec<2> pull = g * (std::sin(slope) * plane.along - std::cos(slope) * plane.normal);
    run->problem.settings.gravity = {pull[0], pull[1]};
    run->problem.settings.courant = safety;
    run->start();
    run->until(1.0);
    const double mark = run->points.position<2>(0).dot(plane.along);
    double start = 0.0, end = 0.0;
    const auto place = [&] {
      double sum = 0.0;
      for (Index row = 0; row < run->points.size(); ++row) {
        sum += run->points.position<2>(row).dot(plane.along);
      }
      return sum / static_cast<double>(run->points.size());
    };
    start = place();
    run->until(3.0);
    end = place();
    CAPTURE(safety, (end - start) / 2.0, mark);
    CHECK(std::abs(end - start) / 2.0 < 0.005);  // m/s; g t of the time is 20 m/s
  }
}

TEST_CASE("an impact on an obstacle gains no energy, and the account closes") {
  for (VelocityTransfer transfer : all_transfers) {
    const Turned plane(23.0);
    auto run = block(plane, rough(0.3), 0.3, [&](const Vec3&) {
      const Vec<2> v = -2.0 * plane.normal + 0.5 * plane.along;
      return Vec3(v[0], v[1], 0);
    });
    run->problem.settings.transfer = transfer;
    run->problem.settings.courant = 0.9;
    run->start();
    const double before = run->value("kinetic energy");
    run->until(0.8);
    const double after = run->value("kinetic energy") + run->value("elastic energy");
    CAPTURE(name_of(transfer), after / before);
    CHECK(after < 1.01 * before);  // flip 1.004
    CHECK(mean_velocity(*run).dot(plane.normal) > 0.5);
    CHECK(std::abs(run->solver->balances()[0].residual()) < 0.01);
    for (int axis = 0; axis < 2; ++axis) {
      CHECK(std::abs(run->solver->balances()[1 + axis].residual()) < 1e-10);
    }
    CHECK(deepest(*run, plane) < 0.0);
  }
}

TEST_CASE("a moving plane carries a block along and does work on it") {
  const Turned plane(7.0);
  Obstacle pusher;
  pusher.contact = ObstacleContact::no_slip;
  const Vec<2> v = 2.0 * plane.normal + 1.0 * plane.along;
  pusher.velocity = {v[0], v[1]};
  pusher.factor = Table{{0.0, 0.5}, {0.0, 1.0}};
  auto run = block(plane, pusher);
  run->problem.settings.gravity = {-g * plane.normal[0], -g * plane.normal[1]};
  run->start();
  run->until(1.0);
  Vec<2> found = Vec<2>::Zero();
  constexpr int samples = 20;  // the block rocks by .1 m/s
  for (int k = 1; k <= samples; ++k) {
    run->until(1.0 + static_cast<double>(k) / samples);
    found += mean_velocity(*run) / samples;
  }
  CAPTURE(found.dot(plane.normal), found.dot(plane.along));
  CHECK(found.dot(plane.normal) == Approx(2.0).epsilon(0.03));
  CHECK(found.dot(plane.along) == Approx(1.0).epsilon(0.03));
  const double gained = 32 * density * (0.5 * v.squaredNorm() + g * 2.0 * (2.0 - 0.25));
  CHECK(run->value("plane work") == Approx(gained).epsilon(0.02));
}

TEST_CASE("sand that falls on obstacles gives the same bytes for any threads and on resume") {
  const auto make = [] {
    auto run = std::make_unique<Run<2>>(Grid<2>({0, 0}, {3, 3}, 0.1), ShapeFunction::gimp);
    run->add({soil(1e5, 30), 0.25, [](const Vec3&) { return Vec3(0.5, -2.0, 0); }, {}}, 2,
             [](const Vec<2>& x) { return x[1] > 1.2 && x[1] < 2.4 && x[0] < 2.0; });
    run->problem.settings.gravity = {0, -9.81};
    Obstacle ball = rough(0.4);
    ball.shape = Disk{{1.0, 0.5}, 0.52};
    ball.revolutions_per_second = 0.5;
    ball.center = {1.0, 0.5};
    Obstacle floor = rough(0.5);
    floor.shape = HalfSpace{{0.0, 0.13}, {-0.1, 1.0}};
    run->problem.settings.obstacles = {ball, floor};
    run->roller(0, 0);
    run->roller(0, 1);
    return run;
  };
  check_same_bytes(make, 150, 90,
                   [](const Run<2>& run) { CHECK(run.value("obstacle 0 contacts") > 0.0); });
}

TEST_CASE("an obstacle that starts inside a body is refused with its depth and point") {
  auto run = block(Turned(0.0), rough(0.0), -0.4);
  REQUIRE_THROWS_WITH(run->start(), Catch::Contains("plane") && Catch::Contains("body 0") &&
                                        Catch::Contains("point") && Catch::Contains("0.15 m"));
  const auto refused = [](auto change, const char* says) {
    Obstacle obstacle = rough(0.3);
    change(obstacle);
    REQUIRE_THROWS_WITH(block(Turned(0.0), obstacle)->start(), Catch::Contains(says));
  };
  refused([](Obstacle& one) { one.friction = -0.1; }, "friction");
  refused([](Obstacle& one) { one.adhesion = -1; }, "adhesion");
  refused([](Obstacle& one) { one.contact = ObstacleContact::slip; }, "frictional");
  refused([](Obstacle& one) { one.velocity = {1.0}; }, "velocity");
}
