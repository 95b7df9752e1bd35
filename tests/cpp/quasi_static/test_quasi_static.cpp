// The physics as a whole: bytes, resuming, reports, and what it says of bad input.
#include <catch2/catch.hpp>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;
using Catch::Matchers::Contains;

namespace {

HalfSpace side(double x, double y, double out_x, double out_y) {
  return HalfSpace{{x, y}, {out_x, out_y}};
}

SupportSettings wall(const char* name, HeldMotion kind, const Shape& shape, bool inside,
                     std::vector<Value> displacement = {}) {
  return {name, kind, {shape, inside, {}, {}}, std::move(displacement)};
}

/// A block of 4 x 3 turned by 20 degrees on a grid of unit cells, on rollers at the left and below.
struct Block {
  explicit Block(ShapeFunction shape = ShapeFunction::gimp) : shape_function(shape) {
    fill_clipped(points, grid, polygon(block.corners()), 2);
    const Vec<2> a = block.corner;
    settings.supports = {
        wall("left", HeldMotion::roller, side(a[0], a[1], -block.e1[0], -block.e1[1]), true),
        wall("base", HeldMotion::roller, side(a[0], a[1], -block.e2[0], -block.e2[1]), true)};
    settings.body_force = {Table{{0.0, 1.0}, {0.0, 3.0 * -block.e2[0]}},
                           Table{{0.0, 1.0}, {0.0, 3.0 * -block.e2[1]}}};
  }
  QuasiStatic<2>& start() {
    physics = std::make_unique<QuasiStatic<2>>(points, grid, shape_function,
                                               std::vector<Solid>{elastic}, settings);
    return *physics;
  }
  std::string refusal() {
    try {
      start();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
  std::string failure() {
    try {
      start().advance({0.0, 1.0, 0});
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  }
  std::vector<double> state() const {
    std::vector<double> all(points.position().begin(), points.position().end());
    all.insert(all.end(), physics->stress().begin(), physics->stress().end());
    return all;
  }

  ShapeFunction shape_function;
  Rectangle block = Rectangle::turned(20.0, {0.3, 0.2}, 4.0, 3.0);
  Grid<2> grid{Vec<2>(-3.0, -2.0), Vec<2>(6.0, 6.0), 1.0};
  Points points{2};
  QuasiStaticSettings settings;
  std::unique_ptr<QuasiStatic<2>> physics;
};

}  // namespace

TEST_CASE("quasi-static: same bytes for any number of threads") {
  std::vector<double> alone;
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    Block block;
    block.start();
    for (int step = 0; step < 3; ++step) {
      block.physics->advance({step / 3.0, 1.0 / 3.0, step});
    }
    if (threads == 1) {
      alone = block.state();
    }
    CHECK(block.state() == alone);
  }
  set_thread_count(0);
}

TEST_CASE("quasi-static: a resumed run gives the same bytes") {
  for (ShapeFunction shape : {ShapeFunction::linear, ShapeFunction::gimp}) {
    Block whole(shape), first(shape), second(shape);
    for (Block* block : {&whole, &first, &second}) {
      block->start();
    }
    Archive archive;
    for (int step = 0; step < 6; ++step) {
      whole.physics->advance({step / 6.0, 1.0 / 6.0, step});
    }
    for (int step = 0; step < 3; ++step) {
      first.physics->advance({step / 6.0, 1.0 / 6.0, step});
    }
    first.points.save(archive);
    first.physics->save(archive);
    second.points.load(archive);
    second.physics->load(archive);
    for (int step = 3; step < 6; ++step) {
      second.physics->advance({step / 6.0, 1.0 / 6.0, step});
    }
    CHECK(second.state() == whole.state());
  }
}

TEST_CASE("quasi-static: walls carry the load, and the report says how it went") {
  Block block;
  block.start().advance({0.0, 1.0, 0});
  const auto numbers = block.physics->diagnostics();
  const auto number = [&](const std::string& name) {
    for (const auto& [key, value] : numbers) {
      if (key == name) {
        return value;
      }
    }
    FAIL("no " << name);
    return 0.0;
  };
  // Weight 3 * 12 along -e2, on rollers.
  const Vec<2> force = block.physics->support_forces()[0] + block.physics->support_forces()[1];
  CHECK(force.dot(block.block.e2) == Approx(36.0).epsilon(1e-9));
  CHECK(std::abs(force.dot(block.block.e1)) < 36.0 * 1e-9);
  CHECK(number("smallest pivot") > 0.0);
  CHECK(number("residual") < 1e-10);
  CHECK(number("iterations") >= 1);
  CHECK(number("condition estimate") > 1e3);
  CHECK(number("condition estimate") < 1e9);
}

TEST_CASE("quasi-static: a traction stretches a bar") {
  // Uniaxial stress in plane strain; the pull is on the right end of an aligned, unturned block
  // whose ends do not fit the grid.
  Points points(2);
  const Grid<2> grid(Vec<2>(-1.0, -1.0), Vec<2>(6.0, 4.0), 1.0);
  fill_clipped(points, grid, Box{{0.3, 0.0}, {4.6, 3.0}}, 2);
  QuasiStaticSettings settings;
  settings.supports = {wall("left", HeldMotion::roller, side(0.3, 0.0, -1.0, 0.0), true),
                       wall("base", HeldMotion::roller, side(0.0, 0.0, 0.0, -1.0), true)};
  settings.supports[0].surface.within = Box{{0.0, 0.0}, {1.0, 3.0}};
  settings.supports[1].surface.within = Box{{0.3, -1.0}, {4.6, 1.0}};
  settings.tractions = {{"pull", {{}, false, {{4.6, 0.0}, {4.6, 3.0}}, {}}, {2.5, 0.0}}};
  QuasiStatic<2> physics(points, grid, ShapeFunction::linear, {elastic}, settings);
  physics.advance({0.0, 1.0, 0});
  for (Index p = 0; p < points.size(); ++p) {
    const double* s = physics.stress().data() + 6 * p;
    CHECK(s[0] == Approx(2.5).epsilon(1e-9));
    CHECK(s[1] == Approx(0.0).margin(1e-8));
    CHECK(s[2] == Approx(0.3 * 2.5).epsilon(1e-8));
  }
}

TEST_CASE("quasi-static: a wall that cuts nothing is refused by name") {
  Block block;
  block.settings.supports.push_back(wall("far", HeldMotion::fixed, side(5.5, 0.0, 1.0, 0.0), true));
  CHECK_THAT(block.refusal(), Contains("support 'far' cuts no material"));
  Block wrong_side;
  wrong_side.settings.supports.push_back({"line", HeldMotion::fixed, {}, {}});
  CHECK_THAT(wrong_side.refusal(), Contains("support 'line' needs either a shape or a line"));
}

TEST_CASE("quasi-static: contradicting walls are named") {
  Block block;
  SupportSettings twin = block.settings.supports[0];
  twin.name = "twin";
  twin.displacement = {Table{{0.0, 1.0}, {0.0, 0.1}}};
  // Trimmed by no other solid: lines lie where they are.
  const Corners c = block.block.corners();
  block.settings.supports[0].surface = {{}, false, numbers({c[3], c[0]}), {}};
  twin.surface = block.settings.supports[0].surface;
  block.settings.supports.push_back(twin);
  const std::string error = block.failure();
  CHECK_THAT(error, Contains("'left'") && Contains("'twin'") && Contains("contradict"));
}

TEST_CASE("quasi-static: the rigid motion that is left is named") {
  Block sliding;
  sliding.settings.supports.erase(sliding.settings.supports.begin());
  CHECK_THAT(sliding.failure(),
             Contains("held by nothing against translation along") && Contains("0.93969"));
  Block loose;
  loose.settings.supports.clear();
  CHECK_THAT(loose.failure(), Contains("every rigid motion"));
  // A ring in a round roller turns.
  Points points(2);
  const Grid<2> grid(Vec<2>(-6.0, -6.0), Vec<2>(6.0, 6.0), 1.0);
  fill_clipped(points, grid, Annulus{{0.2, 0.1}, 2.0, 4.5}, 2);
  QuasiStaticSettings settings;
  settings.supports = {wall("rim", HeldMotion::roller, Disk{{0.2, 0.1}, 4.5}, true)};
  QuasiStatic<2> physics(points, grid, ShapeFunction::linear, {elastic}, settings);
  CHECK_THROWS_WITH(physics.advance({0.0, 1.0, 0}), Contains("rotation about (0.2, 0.1)"));
}

TEST_CASE("quasi-static: a step that pushes points through a wall is halved, then refused") {
  // A penalty as soft as the block itself gives way by half a cell under the whole load.
  Block block;
  block.settings.enforcement = Enforcement::penalty;
  block.settings.bandwidth = 1.0;
  block.settings.max_penetration = 0.1;
  block.settings.max_cutbacks = 0;
  for (std::size_t axis : {0, 1}) {
    const double weight = -300.0 * block.block.e2[static_cast<int>(axis)];
    block.settings.body_force[axis] = Table{{0.0, 1.0}, {0.0, weight}};
  }
  block.start();
  const std::vector<double> before = block.state();
  CHECK_THROWS_WITH(block.physics->advance({0.0, 1.0, 0}),
                    Contains("after 0 halvings") && Contains("through support 'base'") &&
                        Contains("last converged state is kept"));
  CHECK(block.state() == before);
  Block patient;
  patient.settings = block.settings;
  patient.settings.max_cutbacks = 6;
  const StepReport report = patient.start().advance({0.0, 1.0, 0});
  CHECK(report.accepted < 1.0);
  CHECK(report.accepted > 0.0);
}

TEST_CASE("quasi-static: an indefinite matrix is refused") {
  // Nitsche's form is not coercive where its bandwidth is wide and cuts are thin, without ghosts.
  Points points(2);
  const Grid<2> grid(Vec<2>(-1.0, -1.0), Vec<2>(5.0, 4.0), 1.0);
  fill_clipped(points, grid, Box{{0.999, 0.0}, {4.0, 3.0}}, 2);
  QuasiStaticSettings settings;
  settings.enforcement = Enforcement::nitsche;
  settings.gap_bandwidth = 1.0;
  settings.ghost_penalty = 0.0;
  settings.supports = {
      {"left", HeldMotion::fixed, {{}, false, {{0.999, 3.0}, {0.999, 0.0}}, {}}, {}}};
  QuasiStatic<2> physics(points, grid, ShapeFunction::linear, {elastic}, settings);
  CHECK_THROWS_WITH(physics.advance({0.0, 1.0, 0}),
                    Contains("not positive definite") && Contains("support 'left'"));
}

TEST_CASE("quasi-static: settings out of range are refused") {
  Block block;
  block.settings.bandwidth = -1.0;
  CHECK_THAT(block.refusal(), Contains("bandwidth"));
  Block constant;
  constant.settings.supports[0].displacement = {0.5};
  CHECK_THAT(constant.refusal(), Contains("moves nothing"));
  Block bspline(ShapeFunction::bspline);
  CHECK_THAT(bspline.refusal(), Contains("bspline"));
}
