#include <catch2/catch.hpp>
#include <cmath>

#include "lapilli/peridynamics/influence.hpp"

using namespace lapilli;

TEST_CASE("the exponential of four numbers is that of the standard library") {
  for (double x = 0.0; x > -50.0; x -= 0.0137) {
    const Double4 result = lanes::exp_negative(Double4{x, 0.5 * x, 0.0, -x * x});
    // 1e-15: a few units in the last place of the polynomial.
    REQUIRE(result[0] == Approx(std::exp(x)).epsilon(2e-15));
    REQUIRE(result[1] == Approx(std::exp(0.5 * x)).epsilon(2e-15));
    REQUIRE(result[2] == 1.0);
  }
}

TEST_CASE("weights of four bonds are those of one") {
  for (const Influence influence : {Influence::gaussian, Influence::unity, Influence::spline}) {
    const BondWeight weight{influence, 3.015, 1.0, true};
    const lanes::BondWeightLanes four(weight);
    for (double r = 0.05; r < 3.3; r += 0.07) {
      const Double4 lengths = all(r);
      REQUIRE(four(lengths * lengths, lengths)[2] ==
              Approx(weight(r)).epsilon(1e-13).margin(1e-300));
    }
  }
}

TEST_CASE("the volume correction of Eq. 30 as printed is negative wherever it applies") {
  const BondWeight weight{Influence::unity, 3.015, 1.0, true};
  for (double r = 2.52; r < 3.01; r += 0.05) {
    const double printed = (weight.horizon - 0.5 - r) / 1.0;
    REQUIRE(printed < 0.0);
    REQUIRE(weight(r) >= 0.5);
    REQUIRE(weight(r) <= 1.0);
  }
}

TEST_CASE("the moment of a full lattice is its sum") {
  const BondWeight weight{Influence::gaussian, 1.515, 1.0, true};
  // Four neighbours at 1, four at sqrt 2.
  const double moment = (4.0 * weight(1.0) + 8.0 * weight(std::sqrt(2.0))) / 2.0;
  REQUIRE(lattice_moment(2, weight) == Approx(moment).epsilon(1e-14));
  REQUIRE(lattice_moment(1, weight) == Approx(2.0 * weight(1.0)).epsilon(1e-14));
}
