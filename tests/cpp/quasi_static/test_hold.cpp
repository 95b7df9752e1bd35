// Hold steps: nothing is added after loading, and the walls stay where the load has carried them.
// Moved points integrate cut cells no longer exactly, so a grid that is reset at every step changes
// stresses although nothing happens. What keeps them: shape functions that stand until a point has
// moved by a tenth of a cell, walls and ghosts that remember all displacement since then, and a
// second balance in the step that brings the reset about.
#include <catch2/catch.hpp>

#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

struct Drift {
  double largest = 0.0, rms = 0.0;  // of the stress, over its RMS after loading
};

Drift hold(QuasiStatic<2>& physics, const Points& points, double step) {
  const std::vector<double> before(physics.stress().begin(), physics.stress().end());
  double norm = 0.0, volume = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    volume += points.volume()[p];
    for (int c : {0, 1, 3}) {
      norm += points.volume()[p] * before[6 * p + c] * before[6 * p + c];
    }
  }
  Drift drift;
  for (int k = 0; k < 20; ++k) {
    physics.advance({1.0 + k * step, step, k});
    double square = 0.0;
    for (Index p = 0; p < points.size(); ++p) {
      for (int c : {0, 1, 3}) {
        const double change = physics.stress()[6 * p + c] - before[6 * p + c];
        square += points.volume()[p] * change * change;
        drift.largest = std::max(drift.largest, std::abs(change) / std::sqrt(norm / volume));
      }
    }
    drift.rms = std::max(drift.rms, std::sqrt(square / norm));
  }
  return drift;
}

Drift hold_block(double degrees) {
  const Rectangle block = Rectangle::turned(degrees, Vec<2>::Zero(), 100.0, 100.0);
  const Corners c = block.corners();
  const Grid<2> grid = grid_around(c, 10.0, 2.0);
  Points points(2);
  fill_clipped(points, grid, polygon(c), 1);
  const auto wall = [](const char* name, const Vec<2>& at, const Vec<2>& out,
                       std::vector<Value> motion) {
    const Shape half = HalfSpace{{at[0], at[1]}, {out[0], out[1]}};
    return SupportSettings{name, HeldMotion::roller, {half, true, {}, {}}, std::move(motion)};
  };
  QuasiStaticSettings settings;
  settings.supports = {
      wall("left", c[0], -block.e1, {}), wall("base", c[0], -block.e2, {}),
      wall("top", c[3], block.e2, {}),
      wall("right", c[1], block.e1,
           {Table{{0.0, 1.0}, {0.0, block.e1[0]}}, Table{{0.0, 1.0}, {0.0, block.e1[1]}}})};
  QuasiStatic<2> physics(points, grid, ShapeFunction::linear, {elastic}, settings);
  physics.advance({0.0, 1.0, 0});
  return hold(physics, points, 1.0);
}

Drift hold_cantilever(double h, int m) {
  Rectangle beam = Rectangle::turned(45.0, Vec<2>::Zero(), 100.0, 20.0);
  beam.corner = -10.0 * beam.e2;
  const Corners c = beam.corners();
  Corners room = c;
  for (const Vec<2>& corner : c) {
    room.push_back(corner - 20.0 * beam.e2);
  }
  const Grid<2> grid = grid_around(room, h, 4.0);
  Points points(2);
  fill_clipped(points, grid, polygon(c), m);
  QuasiStaticSettings settings;
  settings.supports.push_back(
      {"end", HeldMotion::fixed, {{}, false, numbers({c[1], c[2]}), {}}, {}});
  for (int axis = 0; axis < 2; ++axis) {
    settings.body_force.push_back(Table{{0.0, 1.0}, {0.0, -0.02 * beam.e2[axis]}});
  }
  QuasiStatic<2> physics(points, grid, ShapeFunction::gimp, {elastic}, settings);
  for (int step = 0; step < 20; ++step) {
    physics.advance({step / 20.0, 0.05, step});
  }
  return hold(physics, points, 0.05);
}

Drift hold_footing(double h, int m) {
  const Grid<2> grid(Vec<2>(-h, -h), Vec<2>(3.0 + h, 3.0 + h), h);
  Points points(2);
  fill_clipped(points, grid, Box{{0.0, 0.0}, {3.0, 3.0}}, m);
  QuasiStaticSettings settings;
  settings.bandwidth = 1e-6;
  settings.supports = {{"left", HeldMotion::roller, {{}, false, {{0.0, 3.0}, {0.0, 0.0}}, {}}, {}},
                       {"right", HeldMotion::roller, {{}, false, {{3.0, 0.0}, {3.0, 3.0}}, {}}, {}},
                       {"base", HeldMotion::roller, {{}, false, {{0.0, 0.0}, {3.0, 0.0}}, {}}, {}},
                       {"footing",
                        HeldMotion::fixed,
                        {{}, false, {{2.0, 3.0}, {1.0, 3.0}}, {}},
                        {0.0, Table{{0.0, 1.0}, {0.0, -0.3}}}}};
  QuasiStatic<2> physics(points, grid, ShapeFunction::gimp, {elastic}, settings);
  for (int step = 0; step < 6; ++step) {
    physics.advance({step / 6.0, 1.0 / 6.0, step});
  }
  return hold(physics, points, 1.0 / 6.0);
}

}  // namespace

TEST_CASE("hold steps: a block in uniform stress stays as it is") {
  for (double degrees : {30.0, 45.0}) {
    const Drift drift = hold_block(degrees);
    INFO(degrees << " degrees: largest " << drift.largest << ", RMS " << drift.rms);
    CHECK(drift.largest <= 1e-6);
  }
}

TEST_CASE("hold steps: cantilever and footing stay balanced") {
  for (const Drift& drift :
       {hold_cantilever(4.0, 2), hold_cantilever(4.0, 4), hold_footing(0.2, 2)}) {
    INFO("largest " << drift.largest << ", RMS " << drift.rms);
    CHECK(drift.rms <= 1e-3);
  }
}
