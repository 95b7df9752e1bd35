// What a history of loads must not lose: at every step the walls carry all loads, whatever resets
// of the grid came before; loads that are taken off leave nothing; peaks of tables count wherever
// the steps of the clock end.
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

using Motion = std::vector<Value>;

Value ramp(double to) { return Table{{0.0, 1.0}, {0.0, to}}; }

/// A block of 1 x 0.9 m between rollers, its lower left corner at `corner`, cells of a tenth.
struct BlockInBox {
  BlockInBox(const Vec<2>& corner, const Solid& solid)
      : grid(Vec<2>(-0.3, -0.3), Vec<2>(1.5, 1.5), 0.1), material(solid) {
    const Vec<2> far = corner + Vec<2>(1.0, 0.9);
    box = Box{{corner[0], corner[1]}, {far[0], far[1]}};
    fill_clipped(points, grid, box, 2);
    low = corner;
    high = far;
  }
  void hold(const char* name, HeldMotion kind, Corners line, Motion motion = {}) {
    settings.supports.push_back({name, kind, {{}, false, numbers(line), {}}, std::move(motion)});
  }
  void load(Corners line, Motion traction, const Value& pressure = 0.0) {
    settings.tractions.push_back({"load", {{}, false, numbers(line), {}}, traction, pressure});
  }
  Corners base() const { return {low, Vec<2>(high[0], low[1])}; }
  Corners left() const { return {Vec<2>(low[0], high[1]), low}; }
  Corners right() const { return {Vec<2>(high[0], low[1]), high}; }
  Corners top(double margin = 0.0) const {
    return {high - Vec<2>(margin, 0.0), Vec<2>(low[0] + margin, high[1])};
  }
  QuasiStatic<2>& start() {
    physics = std::make_unique<QuasiStatic<2>>(points, grid, ShapeFunction::linear,
                                               std::vector<Solid>{material}, settings,
                                               std::vector<Shape>{box});
    return *physics;
  }
  /// As the clock does; `after` gets the time after every step.
  template <class After>
  void run(double size, double end, const After& after) {
    double time = 0.0;
    for (Index k = 0; time < end; ++k) {
      const double left = end - time, step = left < size * (1.0 + 1e-6) ? left : size;
      const StepReport report = physics->advance({time, step, k});
      time = step == left && report.accepted == step ? end : time + report.accepted;
      after(time);
    }
  }
  double plastic_strain() {
    double most = 0.0;
    for (const Field& field : physics->fields()) {
      if (field.name == "plastic_strain") {
        most = *std::max_element(field.values.begin(), field.values.end());
      }
    }
    return most;
  }
  double moved() const {
    double most = 0.0;
    for (const double value : physics->displacement()) {
      most = std::max(most, std::abs(value));
    }
    return most;
  }

  Grid<2> grid;
  Solid material;
  Shape box;
  Points points{2};
  Vec<2> low, high;
  QuasiStaticSettings settings;
  std::unique_ptr<QuasiStatic<2>> physics;
};

VonMises clay(double yield) {
  VonMises soil;
  soil.elastic = {1000.0, 1e6, 0.3};
  soil.yield_stress = {yield, 1.2 * yield};
  soil.plastic_strain = {0.0, 0.01};
  return soil;
}

}  // namespace

TEST_CASE("the walls carry all loads at every step, before and after resets of the grid") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.0, 0.1);
  const std::vector<Solid> solids = {LinearElastic{1000.0, 1e6, 0.3},
                                     LinearElastic{1000.0, 1e6, 0.45}, clay(1e9), clay(1.2e4)};
  for (std::size_t k = 0; k < 8; ++k) {
    BlockInBox block(Vec<2>(anywhere(random), k < 4 ? 0.0 : anywhere(random)), solids[k % 4]);
    const double side_load = k % 3 == 0 ? 0.0 : 700.0, weight = 9000.0;
    block.settings.gravity = {0.0, k < 4 ? Value(-10.0) : ramp(-10.0)};
    block.hold("base", HeldMotion::roller, block.base());
    block.hold("left", HeldMotion::roller, block.left(), {ramp(0.025), 0.0});
    block.hold("right", HeldMotion::roller, block.right());
    if (side_load > 0.0) {
      block.load(block.top(), {0.0, -side_load});
    }
    block.start();
    double worst = 0.0;
    block.run(0.1, 1.0, [&](double time) {
      Vec<2> sum(0.0, -weight * (k < 4 ? 1.0 : time) - side_load);
      for (const Vec<2>& force : block.physics->support_forces()) {
        sum += force;
      }
      worst = std::max(worst, sum.norm() / weight);
    });
    INFO("case " << k << ": " << worst);
    // Tractions follow a surface that stretches.
    CHECK(worst < (side_load > 0.0 ? 5e-3 : 1e-7));
  }
}

TEST_CASE("loads that are taken off leave an elastic body as it was") {
  for (const int kind : {0, 1, 2, 3}) {
    for (const double size : {0.5, 0.25, 0.125}) {
      BlockInBox block(Vec<2>(0.03, 0.0), LinearElastic{1000.0, 1e8, 0.3});
      const Value cycle = Table{{0.0, 0.5, 1.0, 1.25}, {0.0, 1.0, 0.0, 0.0}};
      const auto times = [&](double factor) {
        Table table = std::get<Table>(cycle.form());
        for (double& value : table.values) {
          value *= factor;
        }
        return Value(table);
      };
      block.hold("base", HeldMotion::fixed, block.base());
      if (kind == 0) {
        block.settings.gravity = {0.0, times(-10.0)};
      } else if (kind == 1) {
        block.load(block.top(0.3), {}, times(1e4));
      } else if (kind == 2) {
        block.load(block.top(0.3), {times(1e4), 0.0});
      } else {
        block.hold("top", HeldMotion::fixed, block.top(0.3), {0.0, times(-1e-4)});
      }
      block.start();
      double most = 0.0;
      block.run(size, 1.25, [&](double) { most = std::max(most, block.moved()); });
      INFO("kind " << kind << ", steps of " << size << ": " << block.moved() / most);
      CHECK(most > 0.0);
      CHECK(block.moved() < 1e-3 * most);
      CHECK(block.physics->warnings().empty());
    }
  }
}

TEST_CASE("peaks, pulses and jumps of a load count wherever the clock's steps end") {
  struct History {
    const char* name;
    Table pull;
  };
  const double peak = 1.3e4, rest = 1e3;
  for (const History& history :
       {History{"peak", {{0.0, 0.35, 0.7}, {0.0, peak, rest}}},
        History{"pulse", {{0.0, 0.5, 0.55, 0.6}, {0.0, rest, peak, rest}}},
        History{"drop", {{0.0, 0.5, 0.5}, {0.0, peak, rest}}},
        History{"rise", {{0.0, 0.42, 0.42, 0.6}, {0.0, rest, peak, rest}}}}) {
    double finest = 0.0;
    for (const int steps : {25, 10, 7, 4, 1}) {
      BlockInBox bar(Vec<2>(0.0, 0.0), clay(1e4));
      bar.settings.update_volumes = false;
      bar.settings.reset = 1.0;
      bar.hold("base", HeldMotion::roller, bar.base());
      bar.hold("side", HeldMotion::roller, bar.left());
      bar.load(bar.top(), {0.0, history.pull});
      bar.start();
      std::set<Index> whole;
      bar.run(1.0 / steps, 1.0, [&](double time) {
        const double at = time * steps;
        if (std::abs(at - std::round(at)) < 1e-4) {
          whole.insert(std::lround(at));
        }
      });
      const double strain = bar.plastic_strain();
      finest = steps == 25 ? strain : finest;
      INFO(history.name << " in " << steps << " steps: " << strain << ", finest " << finest);
      CHECK(strain > 1e-3);
      CHECK(std::abs(strain - finest) < 0.02 * finest);
      CHECK(std::ssize(whole) == steps);  // cut steps come back to the clock's
    }
  }
}
