#include <catch2/catch.hpp>
#include <limits>

#include "lapilli/materials/thermal.hpp"

using namespace lapilli;

TEST_CASE("thermal coefficients out of range are refused") {
  Thermal sound{2000.0, 800.0, 2.0, 0.0, {}, {}};
  REQUIRE_NOTHROW(check(sound));
  REQUIRE(sound.conductivity.constant().is_scalar());
  for (double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                     std::numeric_limits<double>::infinity()}) {
    Thermal density = sound, heat = sound, conductivity = sound;
    density.density = bad;
    heat.specific_heat = bad;
    conductivity.conductivity = bad;
    REQUIRE_THROWS_AS(check(density), std::invalid_argument);
    REQUIRE_THROWS_AS(check(heat), std::invalid_argument);
    if (bad != 0.0) {
      REQUIRE_THROWS_AS(check(conductivity), std::invalid_argument);
    }
  }
}

TEST_CASE("a conductivity tensor is judged by its principal values") {
  Thermal material{1.0, 1.0, SymmetricTensor{2.0, 2.0, 1.0, 1.0, 0.0, 0.0},
                   0.0, {},  {}};  // principal values 3, 1, 1
  REQUIRE_NOTHROW(check(material));
  REQUIRE_FALSE(material.conductivity.constant().is_scalar());
  REQUIRE(largest_conductivity(material) == Approx(3.0).epsilon(1e-14));
  material.conductivity = SymmetricTensor{2.0, 2.0, 1.0, 3.0, 0.0, 0.0};  // 5, -1, 1
  REQUIRE_THROWS_AS(check(material), std::invalid_argument);
}
