#include <catch2/catch.hpp>
#include <cmath>

#include "lapilli/core/diagnostics.hpp"
#include "lapilli/core/probes.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/simulation.hpp"

using namespace lapilli;

namespace {

/// A field that is set once and never evolved.
class Still : public Physics {
 public:
  Still(Points& points, double slope, double broken_from)
      : values_(points, 1), broken_from_(broken_from) {
    for (Index row = 0; row < points.size(); ++row) {
      const Vec<2> at = points.position<2>(row);
      values_[row] = 1.0 + slope * at[0] - 2.0 * slope * at[1];
    }
  }
  std::string name() const override { return "still"; }
  StepLimit step_limit() const override { return {}; }
  StepReport advance(const Step& step) override {
    if (step.time >= broken_from_) {
      values_[3] = std::nan("");
    }
    return {step.size, 0, 0.0};
  }
  std::vector<Field> fields() override { return {{"height", "m", 1, values_.values()}}; }
  std::vector<std::pair<std::string, double>> diagnostics() const override {
    return {{"force of wall 'a b' along x", 3.0}, {"kinetic energy", 4.0}};
  }
  void save(Archive&) const override {}
  void load(const Archive&) override {}

 private:
  PointArray values_;
  double broken_from_;
};

Simulation still(double broken_from = 1e9) {
  auto points = std::make_unique<Points>(2);
  std::vector<double> positions, volumes;
  for (int k = 0; k < 36; ++k) {
    positions.push_back(0.5 + k % 6);
    positions.push_back(0.5 + k / 6);
    volumes.push_back(1.0);
  }
  points->append(positions, volumes, 0);
  std::vector<std::unique_ptr<Physics>> physics;
  physics.push_back(std::make_unique<Still>(*points, 0.5, broken_from));
  return Simulation(std::move(points), std::move(physics), {10.0, 1.0, 10.0});
}

}  // namespace

TEST_CASE("a value that is not finite is shown to nobody") {
  Simulation simulation = still(2.0);
  simulation.step();
  simulation.step();
  CHECK_NOTHROW(simulation.fields());
  simulation.step();
  CHECK_THROWS_AS(simulation.fields(), RunError);
  CHECK_THROWS_WITH(simulation.fields(),
                    Catch::Contains("time 3 s: height of point 3 is not finite"));
}

TEST_CASE("scalars have snake_case names, units of the dimension, meanings") {
  Simulation simulation = still();
  const std::vector<Scalar> all = diagnostics_of(simulation);
  REQUIRE(all.size() == 2);
  CHECK(all[0].name == "still/force_of_wall_a_b_along_x");
  CHECK(all[0].unit == "N/m");
  CHECK(all[1].name == "still/kinetic_energy");
  CHECK(all[1].unit == "J/m");
  for (const Scalar& scalar : scalars_of(simulation, 1)) {
    CHECK_FALSE(scalar.meaning.empty());
  }
}

TEST_CASE("probes read linear fields exactly, at any position and whatever the order of rows") {
  Simulation simulation = still();
  std::vector<Index> order(36);
  for (Index row = 0; row < 36; ++row) {
    order[static_cast<std::size_t>(row)] = (7 * row + 3) % 36;
  }
  const std::vector<Probe> probes = {{"a", {2.3, 3.1, 0.0}, "height", false},
                                     {"b", {0.1, 5.9, 0.0}, "height", false},
                                     {"c", {3.4, 1.4, 0.0}, "position", true},
                                     {"d", {9.0, 3.0, 0.0}, "height", false}};
  const Probes all(simulation, probes, 1);
  for (int turn = 0; turn < 2; ++turn) {
    const std::vector<Scalar> found = all.read(simulation);
    REQUIRE(found.size() == 5);
    CHECK(found[0].value == Approx(1.0 + 0.5 * 2.3 - 3.1).epsilon(1e-12));
    CHECK(found[1].value == Approx(1.0 + 0.5 * 0.1 - 5.9).epsilon(1e-12));
    CHECK(found[2].name == "c_x");
    CHECK(found[2].value == 3.5);
    CHECK(found[3].value == 1.5);
    CHECK(std::isnan(found[4].value));
    simulation.points().permute(order);
  }
  CHECK_THROWS_WITH(all.read(simulation, true), Catch::Contains("'d' is outside of every body"));
}
