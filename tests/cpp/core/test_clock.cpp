#include <catch2/catch.hpp>
#include <memory>

#include "lapilli/core/simulation.hpp"

using namespace lapilli;

namespace {

/// Takes steps up to a limit, and no more of each than it accepts.
class Paced : public Physics {
 public:
  explicit Paced(StepLimit limit, double accepts = 1e9)
      : limit_(std::move(limit)), accepts_(accepts) {}
  std::string name() const override { return "paced"; }
  StepLimit step_limit() const override { return limit_; }
  StepReport advance(const Step& step) override { return {std::min(step.size, accepts_), 0, 0.0}; }
  std::vector<Field> fields() override { return {}; }
  void save(Archive&) const override {}
  void load(const Archive&) override {}

 private:
  StepLimit limit_;
  double accepts_;
};

StepLimit limited(double automatic, bool even = false) {
  StepLimit limit;
  limit.hard = 2.0 * automatic;
  limit.automatic = automatic;
  limit.even = even;
  return limit;
}

Simulation paced(std::vector<std::unique_ptr<Physics>> physics) {
  return Simulation(std::make_unique<Points>(2), std::move(physics), {10.0, 0.0, 10.0});
}

Simulation paced(const StepLimit& limit) {
  std::vector<std::unique_ptr<Physics>> physics;
  physics.push_back(std::make_unique<Paced>(limit));
  return paced(std::move(physics));
}

}  // namespace

TEST_CASE("the automatic step is taken, not the largest that is allowed") {
  CHECK(paced(limited(0.25)).step().accepted == 0.25);
}

TEST_CASE("a remainder of rounding size is no step of its own") {
  Simulation simulation = paced(limited(0.1));
  simulation.run_until(0.1 * (1.0 + 1e-8));
  CHECK(simulation.step_index() == 1);
}

TEST_CASE("even steps are as many as needed, rounding aside") {
  Simulation simulation = paced(limited(0.1, true));
  simulation.run_until(0.3 * (1.0 + 1e-8));
  CHECK(simulation.step_index() == 3);
  simulation.run_until(0.55);
  CHECK(simulation.step_index() == 6);
}

TEST_CASE("the clock stops at the very time that was asked for") {
  for (int k = 1; k <= 200; ++k) {
    Simulation simulation = paced(limited(5.0));
    simulation.run_until(0.1);
    const double end = 0.3 + 0.01 * k;
    simulation.run_until(end);
    REQUIRE(simulation.time() == end);
    REQUIRE(simulation.step_index() == 2);
  }
}

TEST_CASE("the step that the clock takes is the least that any physics accepts") {
  std::vector<std::unique_ptr<Physics>> physics;
  physics.push_back(std::make_unique<Paced>(limited(0.1), 0.05));
  physics.push_back(std::make_unique<Paced>(limited(0.1)));
  Simulation simulation = paced(std::move(physics));
  CHECK(simulation.step().accepted == 0.05);
  CHECK(simulation.time() == 0.05);
}
