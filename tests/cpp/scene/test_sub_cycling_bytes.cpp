// What must not change heat that takes its own steps: looking, stopping, threads.
#include <catch2/catch.hpp>

#include "lapilli/core/parallel.hpp"
#include "scene/sub_cycling.hpp"

using namespace sub_cycling;

namespace {

/// The soil with expansion, and a second body of another material upon it.
const std::string layers =
    replaced(replaced(soil, "[dynamics]", expansion), "[[bodies]]", R"([[bodies]]
shape = {kind = "box", lower = [0.0, 0.8], upper = [0.3, 0.95]}
material = [
  {kind = "elastic", density = 1000.0, youngs_modulus = 1e6, poissons_ratio = 0.2},
  {kind = "thermal", density = 1000.0, specific_heat = 1.0, conductivity = 5.0},
]
[[bodies]])");

}  // namespace

TEST_CASE("Looking at heat between its steps changes nothing") {
  const auto looked = start(soil), alone = start(soil);
  while (looked->time() < looked->end()) {
    looked->step(looked->end(), true);
    looked->fields();
  }
  alone->run_until(alone->end());
  CHECK(everything(*looked) == everything(*alone));
}

TEST_CASE("A run with steps of heat is resumed with the same bytes from any step") {
  const bool looked = GENERATE(false, true);
  for (const int steps : {1, 2, 5, 11, 16, 23, 40, 77}) {
    const auto whole = start(layers), resumed = start(layers);
    for (int k = 0; k < steps; ++k) {
      whole->step(1e9, false);
    }
    if (looked) {
      whole->fields();
    }
    Archive archive;
    whole->save(archive);
    resumed->load(archive);
    CHECK(everything(*resumed) == everything(*whole));
    whole->run_until(whole->end());
    resumed->run_until(resumed->end());
    INFO("after " << steps << " steps");
    CHECK(everything(*resumed) == everything(*whole));
  }
}

TEST_CASE("Where conduction bounds the step a run resumed just after a sort has the same bytes") {
  const std::string own_steps = replaced(layers, "conductivity = 5.0", "conductivity = 5000.0");
  const std::string quick = GENERATE(false, true) ? own_steps : in_every_step(own_steps);
  const auto whole = start(quick);
  std::vector<Archive> sorted;
  while (whole->time() < whole->end()) {
    const Index before = whole->points().ordering();
    whole->step(whole->end(), false);
    if (whole->points().ordering() != before) {
      whole->save(sorted.emplace_back());
    }
  }
  REQUIRE(sorted.size() > 3);
  for (std::size_t k = 0; k < sorted.size(); k += 3) {
    const auto resumed = start(quick);
    resumed->load(sorted[k]);
    resumed->run_until(resumed->end());
    INFO("sort " << k);
    CHECK(everything(*resumed) == everything(*whole));
  }
}

TEST_CASE("Steps of heat are the same bytes for any number of threads") {
  std::vector<double> one;
  for (const int threads : {1, 2, 4}) {
    set_thread_count(threads);
    const std::vector<double> now = everything(*at_end(layers));
    one = threads == 1 ? now : one;
    CHECK(now == one);
  }
  set_thread_count(0);
}
