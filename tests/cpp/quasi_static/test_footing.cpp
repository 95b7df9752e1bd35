// Cortis et al. 5.5: a rough footing of 1 m pressed 1 m into a block of 3 x 3 m between rollers;
// h = 0.2, four points per cell.
#include <catch2/catch.hpp>

#include "lapilli/core/require.hpp"
#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

struct Pressed {
  std::vector<double> force;      // on the footing, after each step
  double highest_point = -1e300;  // above the footing, of points under it
  bool finished = false;
  std::string error;
};

Pressed press(int steps, ShapeFunction shape, const QuasiStaticSettings& form) {
  const double h = 0.2;
  const Grid<2> grid(Vec<2>(-h, -h), Vec<2>(3.0 + h, 3.0 + h), h);
  Points points(2);
  fill_clipped(points, grid, Box{{0.0, 0.0}, {3.0, 3.0}}, 2);
  QuasiStaticSettings settings = form;
  settings.update_volumes = false;  // its forces are compared with a reference that keeps them
  settings.supports = {{"left", HeldMotion::roller, {{}, false, {{0.0, 3.0}, {0.0, 0.0}}, {}}, {}},
                       {"right", HeldMotion::roller, {{}, false, {{3.0, 0.0}, {3.0, 3.0}}, {}}, {}},
                       {"base", HeldMotion::roller, {{}, false, {{0.0, 0.0}, {3.0, 0.0}}, {}}, {}},
                       {"footing",
                        HeldMotion::fixed,
                        {{}, false, {{2.0, 3.0}, {1.0, 3.0}}, {}},
                        {0.0, Table{{0.0, 1.0}, {0.0, -1.0}}}}};
  QuasiStatic<2> physics(points, grid, shape, {elastic}, settings);
  const std::vector<double> start(points.position().begin(), points.position().end());
  Pressed result;
  try {
    double time = 0.0;
    for (int step = 0; step < steps; ++step) {
      const double next = (step + 1.0) / steps;
      while (time < next) {
        const StepReport report = physics.advance({time, next - time, step});
        time = report.accepted == next - time ? next : time + report.accepted;
      }
      result.force.push_back(-physics.support_forces()[3][1]);
      for (Index p = 0; p < points.size(); ++p) {
        const double x = points.position()[2 * p], x0 = start[2 * p];
        if (x0 > 1.0 && x0 < 2.0 && x > 1.0 + 1e-6 && x < 2.0 - 1e-6) {
          result.highest_point =
              std::max(result.highest_point, points.position()[2 * p + 1] - (3.0 - next));
        }
      }
    }
    result.finished = true;
  } catch (const RunError& error) {
    result.error = error.what();
  }
  return result;
}

}  // namespace

TEST_CASE("footing: no point crosses it, whatever the number of steps") {
  // As the reference was run: walls of 1e-6 cells, every step on the grid where it starts.
  QuasiStaticSettings form;
  form.bandwidth = 1e-6;
  form.relaxation = 0.0;
  double least = 1e300, most = 0.0;
  for (int steps : {17, 20, 40}) {
    const Pressed pressed = press(steps, ShapeFunction::gimp, form);
    INFO(steps << " steps: " << pressed.error << " highest point " << pressed.highest_point
               << ", force " << (pressed.force.empty() ? 0.0 : pressed.force.back()));
    REQUIRE(pressed.finished);
    CHECK(pressed.highest_point < 0.0);
    least = std::min(least, pressed.force.back());
    most = std::max(most, pressed.force.back());
    if (steps == 20) {
      CHECK(pressed.force[1] == Approx(93.6).epsilon(0.01));
    }
    if (steps == 40) {
      CHECK(pressed.force[3] == Approx(94.5).epsilon(0.01));
    }
  }
  INFO("force at 1 m: " << least << " to " << most);
  CHECK(most / least < 1.03);
  CHECK(least > 1390.0);
  CHECK(most < 1450.0);
}

TEST_CASE("footing: the paper's rule loses the wall in empty cells and is refused") {
  QuasiStaticSettings paper;
  paper.enforcement = Enforcement::literal;
  paper.hold_empty_cells = false;
  const Pressed pressed = press(17, ShapeFunction::linear, paper);
  INFO(pressed.error);
  CHECK_FALSE(pressed.finished);
  CHECK(pressed.error.find("support 'footing'") != std::string::npos);
}
