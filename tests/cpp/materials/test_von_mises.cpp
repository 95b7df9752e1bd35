#include <catch2/catch.hpp>
#include <cmath>

#include "driver.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

const LinearElastic steel{7800.0, 2e11, 0.3};

VonMises hardening() {
  VonMises metal;
  metal.elastic = steel;
  metal.yield_stress = {2.5e8, 3.0e8, 3.2e8};
  metal.plastic_strain = {0.0, 0.01, 0.05};
  return metal;
}

VonMises perfect() {
  VonMises metal;
  metal.elastic = steel;
  metal.yield_stress = {2.5e8};
  return metal;
}

}  // namespace

TEST_CASE("a bar follows the table of its hardening") {
  // Uniaxial: strain = stress / E + plastic strain, on every line of the table and beyond it.
  for (const int steps : {1, 3, 60}) {
    LoadedPoint bar(hardening());
    const double end = 0.02;  // on the second line
    for (int step = 0; step < steps; ++step) {
      bar.load({end / steps, 0, 0, 0, 0, 0}, 0b000110, {});
    }
    const double slope = 0.2e8 / 0.04, young = steel.youngs_modulus;
    const double stress = (end + 3.0e8 / slope - 0.01) / (1.0 / young + 1.0 / slope);
    CAPTURE(steps);
    REQUIRE(bar.stress[0] == Approx(stress).epsilon(1e-10));
    REQUIRE(bar.state[0] == Approx(end - stress / young).epsilon(1e-10));
    REQUIRE(std::abs(bar.stress[1]) < 1e-10 * stress);
    bar.load({0.1, 0, 0, 0, 0, 0}, 0b000110, {});
    REQUIRE(bar.stress[0] == Approx(3.2e8).epsilon(1e-10));
    // Turned round, it yields at as much: isotropic.
    bar.load({-0.1, 0, 0, 0, 0, 0}, 0b000110, {});
    REQUIRE(bar.stress[0] == Approx(-3.2e8).epsilon(1e-10));
  }
}

TEST_CASE("simple shear hardens as the table says") {
  // tau = yield / sqrt(3), gamma = tau / G + sqrt(3) plastic strain.
  LoadedPoint point(hardening());
  const double gamma = 0.01;
  for (int step = 0; step < 7; ++step) {
    point.load({0, 0, 0, gamma / 7, 0, 0}, 0, {});
  }
  const double slope = 0.5e8 / 0.01, shear = steel.shear_modulus(), root = std::sqrt(3.0);
  const double tau = (gamma + root * 2.5e8 / slope) / (1.0 / shear + 3.0 / slope);
  REQUIRE(point.stress[3] == Approx(tau).epsilon(1e-10));
  REQUIRE(point.state[0] == Approx((root * tau - 2.5e8) / slope).epsilon(1e-10));
}

TEST_CASE("plane strain yields at two over the root of three of the uniaxial stress") {
  LoadedPoint plate(perfect());
  int most = 0;
  for (int step = 0; step < 100; ++step) {
    most = std::max(most, plate.load({1e-3, 0, 0, 0, 0, 0}, 0b000010, {}));
  }
  REQUIRE(plate.stress[0] == Approx(2.5e8 * 2 / std::sqrt(3.0)).epsilon(1e-10));
  REQUIRE(plate.stress[2] == Approx(0.5 * plate.stress[0]).epsilon(1e-8));
  REQUIRE(most <= 8);
}

TEST_CASE("a plate pulled in its plane hardens in plane strain as the table says") {
  // Linear hardening H and a steady ratio r of the stress across the plane to that along: nothing
  // strains across, (r - nu) / E + (r - 1/2) / H = 0; along, d strain / d stress is
  // (1 - nu r) / E + (1 - r/2) / H. The way there fades with the power E / H = 100 of the stress.
  VonMises metal = perfect();
  const double slope = 2e9;
  metal.yield_stress = {2.5e8, 2.5e8 + 10.0 * slope};
  metal.plastic_strain = {0.0, 10.0};
  LoadedPoint plate(metal);
  for (int step = 0; step < 400; ++step) {
    plate.load({2e-3, 0, 0, 0, 0, 0}, 0b000010, {});
  }
  const double before = plate.stress[0];
  plate.load({2e-3, 0, 0, 0, 0, 0}, 0b000010, {});
  const double soft = 1.0 / steel.youngs_modulus, plastic = 1.0 / slope, nu = 0.3;
  const double ratio = (nu * soft + 0.5 * plastic) / (soft + plastic);
  const double compliance = (1.0 - nu * ratio) * soft + (1.0 - 0.5 * ratio) * plastic;
  REQUIRE(plate.stress[2] / plate.stress[0] == Approx(ratio).epsilon(1e-10));
  REQUIRE((plate.stress[0] - before) / 2e-3 == Approx(1.0 / compliance).epsilon(1e-10));
}

TEST_CASE("von Mises parameters that cannot be used are refused") {
  const auto refused = [](auto change, const char* says) {
    VonMises material = hardening();
    REQUIRE_NOTHROW(check(material));
    change(material);
    REQUIRE_THROWS_WITH(check(material), Catch::Contains(says));
  };
  refused([](VonMises& m) { m.yield_stress = {}; }, "at least one");
  refused([](VonMises& m) { m.yield_stress = {1.0, 2.0}; }, "as many numbers as yield_stress, 2");
  refused([](VonMises& m) { m.yield_stress[1] = 2.0e8; }, "must not fall");
  refused([](VonMises& m) { m.yield_stress[0] = -1.0; }, "positive");
  refused([](VonMises& m) { m.plastic_strain[0] = 0.001; }, "begin at 0");
  refused([](VonMises& m) { m.plastic_strain[2] = 0.01; }, "must rise");
  refused([](VonMises& m) { m.plastic_strain = {}; }, "got 0");
  refused([](VonMises& m) { m.elastic.density = 0.0; }, "density");
}
