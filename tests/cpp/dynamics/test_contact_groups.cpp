// Which bodies are bonded, and which meet.
#include <catch2/catch.hpp>

#include "dynamics/balls.hpp"

using namespace dynamics_test;

namespace {

/// Two blocks of 4 by 4 cells that lie side by side, `apart` cells from each other.
std::unique_ptr<Run<2>> side_by_side(double apart, double speed) {
  auto run = std::make_unique<Run<2>>(Grid<2>({-8, -8}, {8, 8}, 1.0), ShapeFunction::gimp);
  for (int side : {-1, 1}) {
    DynamicsBody body = moving<2>({side * speed, 0.0}, side < 0 ? "left" : "right");
    run->add(body, 2, [&](const Vec<2>& x) {
      const double from = side * x[0] - 0.5 * apart;
      return from > 0 && from < 4 && std::abs(x[1]) < 2;
    });
  }
  return run;
}

bool in_contact(const Run<2>& run) {
  for (const auto& [name, number] : run.solver->diagnostics()) {
    if (name == "contact nodes") {
      return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("bodies that start along a common face are bonded unless told otherwise") {
  auto run = side_by_side(0.0, 0.0);
  run->start();
  CHECK_FALSE(in_contact(*run));
  run = side_by_side(0.5, 0.0);
  run->start();
  CHECK(in_contact(*run));
  run = side_by_side(0.0, 1.0);  // they part
  run->start();
  CHECK(in_contact(*run));
  run = side_by_side(0.0, 0.0);
  run->problem.settings.contacts = {{{"right", "left"}, ContactKind::frictional, 0.0, 0.0}};
  run->start();
  CHECK(in_contact(*run));
  run = side_by_side(0.5, 0.0);
  run->problem.settings.contacts = {{{}, ContactKind::bonded, 0.0, 0.0}};
  run->start();
  CHECK_FALSE(in_contact(*run));
  // Disks that touch in a point.
  for (double radius : {4.0, 8.0}) {
    Balls<2> balls({.radius = radius, .speed = 0.0, .gap = 0.0});
    balls.run.problem.settings.contacts.clear();
    balls.run.start();
    CHECK(in_contact(balls.run));
  }
}

TEST_CASE("bodies in contact part without tension") {
  auto run = side_by_side(0.0, 1.0);
  run->start();
  run->until(0.1);
  CHECK(run->value("elastic energy") == 0.0);
}

TEST_CASE("entries of contacts that cannot be are refused by name") {
  const auto refuses = [](std::vector<BodyContact> contacts, const char* text) {
    auto run = side_by_side(0.0, 0.0);
    run->problem.settings.contacts = std::move(contacts);
    CHECK_THROWS_WITH(run->start(), Catch::Contains(text));
  };
  const auto kind = ContactKind::frictional;
  refuses({{{"left"}, kind, 0.0, 0.0}}, "dynamics.contacts.0.bodies needs the names of two bodies");
  refuses({{{"left", "left"}, kind, 0.0, 0.0}}, "names left twice");
  refuses({{{"left", "rigt"}, kind, 0.0, 0.0}}, "rigt");
  refuses({{{"left", "right"}, kind, -1.0, 0.0}}, "friction must not be negative");
  refuses({{{"left", "right"}, ContactKind::bonded, 1.0, 0.0}}, "belong to contact");
  refuses({{{"left", "right"}, kind, 0.1, 0.0}, {{"right", "left"}, kind, 0.2, 0.0}},
          "have an entry already");
  refuses({{{}, kind, 0.1, 0.0}, {{}, kind, 0.2, 0.0}}, "one entry may be about all other pairs");
}
