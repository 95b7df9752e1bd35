// Explicit steps of many stages: consistent of second order, stable and without a change of sign
// over all of their interval.
#include <catch2/catch.hpp>
#include <cmath>

#include "lapilli/mpm/heat/chebyshev_stages.hpp"

namespace lapilli {
namespace {

/// What one step of size 1 leaves of y = 1 where dy/dt = -rate y + forcing(t).
template <class Forcing>
double after_a_step(int count, double rate, const Forcing& forcing) {
  const ChebyshevStages stages(count);
  const auto slope = [&](double y, double t) { return -rate * y + forcing(t); };
  const double start = 1.0, first = slope(start, 0.0);
  double before = start, now = start + stages.first() * first, at = stages.first();
  for (const ChebyshevStages::Stage& stage : stages.later()) {
    const double next = (1.0 - stage.mu - stage.nu) * start + stage.mu * now + stage.nu * before +
                        stage.rate * slope(now, at) + stage.start * first;
    before = now;
    now = next;
    at = stage.at;
  }
  CHECK(at == Approx(1.0).epsilon(1e-12));
  return now;
}

TEST_CASE("A step of stages is of second order") {
  for (const int count : {2, 3, 10, 100}) {
    INFO(count << " stages");
    const auto none = [](double) { return 0.0; };
    CHECK(std::abs(after_a_step(count, 1e-2, none) - std::exp(-1e-2)) < 2e-7);
    CHECK(after_a_step(count, 0.0, [](double t) { return 1.0 + 2.0 * t; }) ==
          Approx(3.0).epsilon(1e-12));
  }
}

TEST_CASE("A step of stages decays without ringing whatever the rates it was made for") {
  for (const double product : {0.1, 1.0, 10.0, 1e3, 1e5, 5e5}) {
    const int count = ChebyshevStages::needed(product);
    CHECK(count * count < 2.0 * product + 10.0);
    for (int k = 1; k <= 1000; ++k) {
      const double left = after_a_step(count, 1e-3 * k * product, [](double) { return 0.0; });
      CHECK(left > 0.2);
      CHECK(left < 1.0 + 1e-9);
    }
  }
}

}  // namespace
}  // namespace lapilli
