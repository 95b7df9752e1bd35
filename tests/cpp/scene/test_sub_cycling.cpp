// Heat in steps of its own beside those of explicit dynamics.
#include <catch2/catch.hpp>

#include "scene/sub_cycling.hpp"

using namespace sub_cycling;

TEST_CASE("Steps of heat that cover many of the motion leave the motion to the byte") {
  const auto often = at_end(in_every_step(soil)), seldom = at_end(soil);
  CHECK(steps_of(*often) == 1.0);
  CHECK(steps_of(*seldom) > 4.0);
  CHECK(by_id(*seldom, "position") == by_id(*often, "position"));
  CHECK(by_id(*seldom, "velocity") == by_id(*often, "velocity"));
  // Work becomes heat in every step, the same share of the same work but for the last step.
  const double work = entry(*often, 0, "plastic work");
  CHECK(entry(*seldom, 0, "plastic work") == Approx(work).epsilon(1e-13));
  CHECK(-0.9 * entry(*seldom, 1, "plastic") == Approx(work).epsilon(0.02));
}

TEST_CASE("Heat in long steps differs little from heat in every step") {
  const auto often = at_end(in_every_step(soil)), seldom = at_end(soil);
  const auto found = by_id(*seldom, "temperature"), wanted = by_id(*often, "temperature");
  const auto [least, most] = std::ranges::minmax(wanted);
  // Found 9e-4 of the range, at loose points, where the surface passes from node to node.
  CHECK(largest_difference(found, wanted) < 2e-3 * (most - least));
  // What comes in depends on where the points are when it comes: found 0.2 % of 30 steps.
  for (const char* name : {"source", "air"}) {
    CHECK(entry(*seldom, 0, name) == Approx(entry(*often, 0, name)).epsilon(4e-3));
  }
}

TEST_CASE("Heat is kept at every step, between those of heat too") {
  const auto simulation = start(soil);
  double largest = 0.0;
  while (simulation->time() < simulation->end()) {
    simulation->step(simulation->end(), false);
    largest = std::max(largest, std::abs(simulation->balances()[0].residual()));
  }
  // Found 1e-12 in the first step, which turns over a thousandth of what is stored; 1e-15 later.
  CHECK(largest < 3e-12);
}

TEST_CASE("Between steps of heat temperature goes on at its rate") {
  const auto often = start(in_every_step(soil)), seldom = start(soil);
  double largest = 0.0;
  for (int k = 0; k < 60; ++k) {
    often->step(1e9, false);
    seldom->step(1e9, false);
    largest = std::max(largest, largest_difference(by_id(*seldom, "temperature_carried"),
                                                   by_id(*often, "temperature_carried")));
  }
  // What it was at the last step of heat would be off by the change over 16 steps.
  const auto before = by_id(*often, "temperature_carried");
  for (int k = 0; k < 16; ++k) {
    often->step(1e9, false);
  }
  const double change = largest_difference(by_id(*often, "temperature_carried"), before);
  CAPTURE(largest, change);
  CHECK(largest < 0.1 * change);
}

TEST_CASE("Stops of the clock find heat where the clock is, at a small cost in error") {
  const auto often = start(soil), once = at_end(soil);
  for (int k = 1; k <= 60; ++k) {
    often->run_until(0.005 * k);
  }
  CHECK(steps_of(*often) < 4.0);
  const double span = 3.0 - 0.2;
  CHECK(largest_difference(by_id(*often, "temperature"), by_id(*once, "temperature")) <
        1e-2 * span);
}

TEST_CASE("Where conduction asks for the smaller steps several fit in one of the motion") {
  // Diffusivity 5 m2/s: 0.5 ms, the motion takes 1.7 ms.
  const std::string quick = replaced(replaced(soil, "conductivity = 1.0", "conductivity = 4000.0"),
                                     "specific_heat = 1.0", "specific_heat = 0.4");
  const auto simulation = at_end(quick);
  // Three whole ones of the 3.5 that would fit, which cost least, and now and then four.
  CHECK(steps_of(*simulation) == Approx(1.0 / 3.0).epsilon(0.15));
  CHECK(std::abs(simulation->balances()[0].residual()) < 1e-12);
  // The motion in smaller steps is another one, and heat with it.
  const auto all_small = at_end(in_every_step(quick));
  CHECK(simulation->step_index() < all_small->step_index() / 2);
  CHECK(largest_difference(by_id(*simulation, "temperature"), by_id(*all_small, "temperature")) <
        0.05 * 2.8);
}

TEST_CASE("Heat takes every step where the user gives it, and where transfers count steps") {
  const std::string automatic = replaced(soil, "subcycling = true\n", "");
  CHECK(steps_of(*at_end(automatic)) > 4.0);
  CHECK(steps_of(*at_end(replaced(automatic, "end = 0.3", "end = 0.3\nstep = 1e-3"))) == 1.0);
  CHECK(steps_of(*at_end(replaced(automatic, "[heat]", "[heat]\ntransfer = \"pic\""))) == 1.0);
  CHECK(steps_of(*at_end(replaced(soil, "[heat]", "[heat]\ntransfer = \"flip\""))) > 4.0);
}

TEST_CASE("Strong exchange with the surroundings is followed in every step") {
  // A node of the surface would take 5 ms to come to its surroundings.
  CHECK(steps_of(*at_end(replaced(soil, "coefficient = 10.0", "coefficient = 2e4"))) == 1.0);
}

TEST_CASE("Thermal strain comes with every step, and shakes nothing") {
  const std::string block = R"(
[grid]
lower = [0.0, 0.0]
upper = [3.0, 2.0]
cell = 0.125
[[bodies]]
shape = {kind = "box", lower = [1.0, 0.5], upper = [2.0, 1.5]}
source = 250000.0
material = [
  {kind = "elastic", density = 1000.0, youngs_modulus = 1e6, poissons_ratio = 0.3},
  {kind = "thermal", density = 1000.0, specific_heat = 1.0, conductivity = 1.0},
  {kind = "thermal_expansion", coefficient = 1e-4},
]
[dynamics]
[heat]
subcycling = true
[time]
end = 0.2
)";
  const auto often = at_end(in_every_step(block)), seldom = at_end(block);
  CHECK(steps_of(*seldom) > 8.0);
  double largest = 0.0;
  const auto wanted = by_id(*often, "stress");
  for (const double stress : wanted) {
    largest = std::max(largest, std::abs(stress));
  }
  // All at once with the steps of heat it would be half of the stress.
  CHECK(largest_difference(by_id(*seldom, "stress"), wanted) < 5e-3 * largest);
  CHECK(entry(*seldom, 1, "expansion") == Approx(entry(*often, 1, "expansion")).epsilon(5e-3));
}
