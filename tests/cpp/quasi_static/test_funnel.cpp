// Cortis et al. 5.6 with a geometry of our own: a block of 60 mm is pushed through a narrowing
// channel whose roof is a curved roller.
#include <catch2/catch.hpp>

#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

double roof(double x) {
  const double s = std::clamp((x - 56.0) / 48.0, 0.0, 1.0);
  return 40.0 - 6.0 * (1.0 - std::cos(std::numbers::pi * s));
}

struct Pushed {
  double force = 0.0;    // of the push in the last step
  double outside = 0.0;  // farthest that a point is behind a wall
  double least = 1e300;  // smallest forward displacement
};

Pushed push(double h, Enforcement form, double bandwidth) {
  const double push_length = 24.0;
  Corners body{{60.0, 0.0}, {60.0, roof(60.0)}};
  for (double x = 59.5; x > 55.9; x -= 0.5) {
    body.push_back({x, roof(x)});
  }
  body.push_back({0.0, 40.0});
  body.push_back({0.0, 0.0});
  const Vec<2> lower(1.3 - 2.0 * h, 0.9 - 2.0 * h);
  const Grid<2> grid(lower, lower + Vec<2>(160.0, 56.0), h);
  Points points(2);
  fill_clipped(points, grid, polygon(body), 2);
  QuasiStaticSettings settings;
  settings.enforcement = form;
  settings.bandwidth = bandwidth;
  settings.ghost_penalty = 0.01;
  settings.relaxation = 0.0;  // as the reference was run, which keeps volumes too
  settings.update_volumes = false;
  Corners top;
  for (double x = 140.0; x > -0.5 * h; x -= h) {
    top.push_back({x, roof(x)});
  }
  settings.supports = {
      {"roof", HeldMotion::roller, {{}, false, numbers(top), {}}, {}},
      {"floor", HeldMotion::roller, {{}, false, {{0.0, 0.0}, {140.0, 0.0}}, {}}, {}},
      {"piston",
       HeldMotion::roller,
       {{}, false, {{0.0, 40.0}, {0.0, 0.0}}, {}},
       {Table{{0.0, 1.0}, {0.0, push_length}}}}};
  QuasiStatic<2> physics(points, grid, ShapeFunction::linear, {elastic}, settings);
  Pushed result;
  for (int step = 0; step < 6; ++step) {
    REQUIRE(physics.advance({step / 6.0, 1.0 / 6.0, step}).accepted == 1.0 / 6.0);
    for (Index p = 0; p < points.size(); ++p) {
      const double x = points.position()[2 * p], y = points.position()[2 * p + 1];
      result.outside =
          std::max({result.outside, y - roof(x), -y, push_length * (step + 1) / 6.0 - x});
    }
  }
  for (Index p = 0; p < points.size(); ++p) {
    result.least = std::min(result.least, physics.displacement()[2 * p]);
  }
  result.force = physics.support_forces()[2][0];
  return result;
}

}  // namespace

TEST_CASE("funnel: a curved roller lets the block slide") {
  const Pushed pushed = push(4.0, Enforcement::mean_gap, 1e-6);
  INFO("force " << pushed.force << ", outside " << pushed.outside << ", least " << pushed.least);
  CHECK(pushed.force > 1000.0);
  CHECK(pushed.force < 1500.0);
  CHECK(pushed.outside <= 0.3);
  CHECK(pushed.least > 20.0);
}

TEST_CASE("funnel: the paper's form sticks to a curved roller") {
  const Pushed stuck = push(4.0, Enforcement::pointwise, 1e-6);
  INFO("force " << stuck.force << ", least " << stuck.least);
  CHECK(stuck.force > 5000.0);
  CHECK(stuck.least < 5.0);
}
