// Bodies that meet in velocity fields of their own.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "dynamics/balls.hpp"

using namespace dynamics_test;

TEST_CASE("two disks return the energy of one that hits a wall") {
  // A face of the grid. Off by .05 and .01, .07 and .05, .01 and .02; through common nodes they
  // would never part at these speeds.
  using Case = std::tuple<double, double, double>;
  for (const auto& [radius, speed, bar] : {Case(5, 0.005, 0.1), {5, 0.02, 0.1}, {10, 0.05, 0.05}}) {
    const Meeting one{.radius = radius, .speed = speed, .wall = true, .offset = {0, 0.29, 0}};
    const double wall = returned<2>(one);
    for (double degrees : {0.0, 31.0}) {
      const double other = returned<2>({.radius = radius, .speed = speed, .degrees = degrees});
      CAPTURE(radius, speed, degrees, wall, other);
      CHECK(other < 1.0);
      CHECK(std::abs(other - wall) < bar);
    }
  }
}

TEST_CASE("contact keeps momentum to rounding") {
  for (StressUpdate update : all_updates) {
    for (ShapeFunction shape : all_shapes) {
      if (shape == ShapeFunction::linear && update == StressUpdate::usl) {
        continue;  // refused off the lattice
      }
      Balls<2> balls({.speed = 0.03,
                      .degrees = 17.0,
                      .aside = 3.0,
                      .friction = 0.4,
                      .shape = shape,
                      .update = update});
      balls.meet();
      const double size = (balls.mass(0) + balls.mass(1)) * 0.03 * wave;
      CAPTURE(name_of(shape), name_of(update), balls.rebound());
      CHECK((balls.momentum() - balls.begin).norm() < 1e-12 * size);
      CHECK(balls.rebound()[0] < -0.6);  // -.81: they have met, and parted
      CHECK(balls.run.value("contact friction") > 0.0);
    }
  }
}

TEST_CASE("balls in space bounce off each other") {
  const Meeting meeting{.radius = 3.0, .speed = 0.03, .degrees = 17.0};
  Balls<3> balls(meeting);
  balls.meet();
  CAPTURE(balls.rebound());
  CHECK((balls.momentum() - balls.begin).norm() <
        1e-12 * (balls.mass(0) + balls.mass(1)) * 0.03 * wave);
  CHECK(balls.rebound()[0] < -0.85);
  CHECK(balls.rebound()[0] > -1.0);
}

TEST_CASE("a meeting knows neither the place of the grid nor its angle") {
  // Ten cells across, .03 c, aside by 3 cells; with friction and without.
  for (double friction : {0.0, 0.3}) {
    const auto rebound = [&](Meeting meeting) {
      meeting.speed = 0.03;
      meeting.aside = 3.0;
      meeting.friction = friction;
      Balls<2> balls(meeting);
      balls.meet();
      return balls.rebound();
    };
    const Vec<2> plain = rebound({});
    CAPTURE(friction, plain);
    CHECK((rebound({.offset = {0.4, -0.1, 0}}) - plain).norm() < 0.02);
    CHECK((rebound({.degrees = 31.0}) - plain).norm() < 0.02);
    CHECK((rebound({.degrees = 90.0, .offset = {-0.29, 0.13, 0}}) - plain).norm() < 1e-6);
  }
}

TEST_CASE("bodies one cell apart feel nothing") {
  Balls<2> balls({.speed = 0.0, .gap = 1.0});
  balls.run.start();
  for (int step = 0; step < 20; ++step) {
    balls.run.advance(balls.run.automatic_step());
  }
  CHECK(balls.run.value("contact nodes") == 0.0);
  CHECK(balls.momentum(0).norm() == 0.0);
}

TEST_CASE("contact begins where the surfaces meet") {
  for (double degrees : {0.0, 23.0, 45.0}) {
    Balls<2> balls({.radius = 10.0, .speed = 0.01, .degrees = degrees, .gap = 0.3});
    balls.run.start();
    while (balls.run.value("contact nodes") == 0.0) {
      balls.run.advance(0.3 / wave);
    }
    const double gap = 0.3 - 2 * 0.01 * wave * balls.run.time;
    CAPTURE(degrees, gap);
    CHECK(std::abs(gap) < 0.05);  // -.021, .003, .000 cells
  }
}

TEST_CASE("contact gives the same bytes for any number of threads, and on resume") {
  const Meeting meeting{.degrees = 17.0, .gap = 0.3, .aside = 2.0, .friction = 0.3};
  const auto state = [](const Balls<2>& balls) {
    const auto values = balls.run.solver->velocity().values();
    return std::vector<double>(values.begin(), values.end());
  };
  Balls<2> one(meeting);
  one.meet(1);
  for (int threads : {2, 4}) {
    Balls<2> other(meeting);
    other.meet(threads);
    CHECK(state(other) == state(one));
  }
  Balls<2> first(meeting), second(meeting);
  first.run.start();
  second.run.start();
  for (int step = 0; step < 60; ++step) {
    first.run.advance(first.run.automatic_step());
  }
  CHECK(first.run.value("contact nodes") > 0.0);
  Archive archive;
  first.run.points.save(archive);
  first.run.solver->save(archive);
  second.run.points.load(archive);
  second.run.solver->load(archive);
  second.run.time = first.run.time;
  second.run.index = first.run.index;
  for (int step = 0; step < 60; ++step) {
    first.run.advance(first.run.automatic_step());
    second.run.advance(second.run.automatic_step());
  }
  CHECK(state(first) == state(second));
  set_thread_count(0);
}

TEST_CASE("three bodies meet in one node") {
  // A disk falls between two that lie on a floor and pushes them apart.
  Run<2> run(Grid<2>({-16, 0}, {16, 20}, 1.0), ShapeFunction::gimp);
  for (double x : {-4.0, 4.0}) {
    fill_ball<2>(run, {x, 4.0}, 4.0, moving<2>({0, 0}, x < 0 ? "left" : "right"));
  }
  fill_ball<2>(run, {0.0, 4.0 + std::sqrt(48.0)}, 4.0, moving<2>({0, 0}, "top"));
  run.roller(1, 0);
  run.problem.settings.gravity = {0, -20};
  run.start();
  run.until(1.0);
  const double mass = std::numbers::pi * 16 * density;
  Vec<2> speed = Vec<2>::Zero();
  double sides = 0.0;
  for (Index row = 0; row < run.points.size(); ++row) {
    const Vec<2> v = Eigen::Map<const Vec<2>>(run.solver->velocity().data() + 2 * row);
    if (run.points.body()[row] == 2) {
      speed += run.solver->mass()[row] * v / mass;
    }
    sides += run.points.body()[row] == 1 ? run.solver->mass()[row] * v[0] / mass : 0.0;
  }
  // Without friction: x = 8 cos a / 2 of the sides, y = 8 sin a of the top; from a = 60 degrees.
  CAPTURE(speed, sides);
  CHECK(std::abs(speed[0]) < 0.02 * std::abs(speed[1]));
  CHECK(sides > 0.5);
  CHECK(run.value("kinetic energy") > 0.0);
}
