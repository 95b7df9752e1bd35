#include <catch2/catch.hpp>
#include <map>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/thread_chooser.hpp"
#include "lapilli/core/thread_limit.hpp"

using lapilli::ThreadChooser;
using Seconds = std::map<int, double>;  // of a step, by threads

namespace {

/// Steps with each number of threads, of so many.
std::map<int, int> steps_of(ThreadChooser& chooser, const Seconds& seconds, int most, int steps) {
  std::map<int, int> counted;
  for (int k = 0; k < steps; ++k) {
    const int threads = chooser.threads(most);
    ++counted[threads];
    chooser.took(seconds.at(threads));
  }
  return counted;
}

}  // namespace

TEST_CASE("the fastest number of threads is found and kept") {
  const Seconds small{{1, 5e-5}, {2, 3e-4}, {4, 5e-4}, {8, 1e-3}};
  const Seconds large{{1, 0.8}, {2, 0.4}, {4, 0.2}, {8, 0.1}};
  const Seconds middle{{1, 4e-3}, {2, 2.1e-3}, {4, 1.9e-3}, {8, 3e-3}};
  for (const auto& [seconds, best] : {std::pair{small, 1}, {large, 8}, {middle, 4}}) {
    ThreadChooser chooser;
    steps_of(chooser, seconds, 8, 1000);
    std::map<int, int> counted = steps_of(chooser, seconds, 8, 10000);
    CAPTURE(best);
    CHECK(counted[best] > 9300);  // others are tried for one in forty of the time
  }
}

TEST_CASE("a processor that becomes busy or free is noticed") {
  const Seconds free{{1, 0.02}, {2, 0.011}}, busy{{1, 0.02}, {2, 0.06}};
  ThreadChooser chooser;
  steps_of(chooser, free, 2, 500);
  steps_of(chooser, busy, 2, 500);
  CHECK(steps_of(chooser, busy, 2, 1000)[1] > 900);
  steps_of(chooser, free, 2, 500);
  CHECK(steps_of(chooser, free, 2, 1000)[2] > 900);
}

TEST_CASE("one thread, or another number of them, needs no trial") {
  ThreadChooser chooser;
  CHECK(steps_of(chooser, {{1, 1e-3}}, 1, 100)[1] == 100);
  CHECK(chooser.threads(2) == 2);
}

TEST_CASE("a limit holds for its life and nests") {
  const int all = lapilli::thread_count();
  {
    const lapilli::ThreadLimit one(1);
    CHECK(lapilli::thread_count() == 1);
    {
      const lapilli::ThreadLimit many(1 << 20);
      CHECK(lapilli::thread_count() == all);
    }
    CHECK(lapilli::thread_count() == 1);
  }
  CHECK(lapilli::thread_count() == all);
}
