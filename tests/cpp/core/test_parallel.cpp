#include <catch2/catch.hpp>
#include <cmath>

#include "lapilli/core/parallel.hpp"

using namespace lapilli;

TEST_CASE("sums are the same bytes for any number of threads") {
  const auto term = [](Index row) { return std::sin(static_cast<double>(row)); };
  set_thread_count(1);
  const double alone = parallel_sum(100'001, 0.0, term);
  for (int threads : {2, 3, 4}) {
    set_thread_count(threads);
    REQUIRE(parallel_sum(100'001, 0.0, term) == alone);
  }
  set_thread_count(0);
  // sum of sin(k) for k < n has a closed form
  const double n = 100'001;
  REQUIRE(alone ==
          Approx(std::sin(0.5 * (n - 1)) * std::sin(0.5 * n) / std::sin(0.5)).margin(1e-9));
}

TEST_CASE("an absurd thread count is refused") {
  REQUIRE_THROWS_AS(set_thread_count(-1), std::invalid_argument);
}
