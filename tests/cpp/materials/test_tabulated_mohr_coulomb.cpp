#include <catch2/catch.hpp>

#include "driver.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

const LinearElastic sand{2000.0, 1e7, 0.3};

TabulatedMohrCoulomb softening() {
  return {sand, {0.0, 0.02, 0.1}, {40.0, 35.0, 30.0}, {12.0, 6.0, 0.0}, {1e3, 5e2, 0.0}};
}

}  // namespace

TEST_CASE("even tables are Mohr-Coulomb, byte for byte") {
  const TabulatedMohrCoulomb even{sand, {0.0, 1.0}, {30.0}, {10.0}, {1e3}};
  const MohrCoulomb plain{sand, 30.0, 10.0, 1e3};
  LoadedPoint one(even), other(plain);
  one.stress = other.stress = SymmetricTensor(-5e3);
  for (int step = 0; step < 20; ++step) {
    one.load({1e-4, -4e-4, 0, 2e-4, 0, 1e-4}, 0, {});
    other.load({1e-4, -4e-4, 0, 2e-4, 0, 1e-4}, 0, {});
    REQUIRE(one.stress == other.stress);
  }
  REQUIRE(one.state[0] > 1e-3);
}

TEST_CASE("triaxial strength follows the tables and the volume stops at the critical state") {
  LoadedPoint point(softening());
  const double cell = -5e3, axial = -1e-4;
  point.stress = SymmetricTensor(cell);
  for (int step = 0; step < 4000; ++step) {
    const double before = point.state[0];
    point.load({0, 0, axial, 0, 0, 0}, 0b000011, {cell});
    if (point.state[0] > before && before > 0.0) {
      // On the yield surface of the plastic strain before the step, linear between the entries.
      const bool first = before < 0.02;
      const double share = first ? before / 0.02 : std::min(1.0, (before - 0.02) / 0.08);
      const auto between = [&](double a, double b) { return (1.0 - share) * a + share * b; };
      const double high = (first ? 40.0 : 35.0) * degree, low = (first ? 35.0 : 30.0) * degree;
      const double sine = between(std::sin(high), std::sin(low));
      const double cohesive =
          between((first ? 1e3 : 5e2) * std::cos(high), (first ? 5e2 : 0.0) * std::cos(low));
      const double expected = ((1.0 + sine) * cell - 2.0 * cohesive) / (1.0 - sine);
      CAPTURE(step, before);
      REQUIRE(point.stress[2] == Approx(expected).epsilon(1e-10));
    }
  }
  REQUIRE(point.state[0] > 0.2);
  // At the critical state the stress stands and nothing dilates any more; on the way it did.
  const double before = point.volume;
  point.load({0, 0, axial, 0, 0, 0}, 0b000011, {cell});
  REQUIRE(std::abs(point.volume - before) < 1e-9 * std::abs(axial));
  REQUIRE(point.volume > 0.005);
}

TEST_CASE("tables that cannot be used are refused") {
  const auto refused = [](auto change, const char* says) {
    TabulatedMohrCoulomb material = softening();
    REQUIRE_NOTHROW(check(material));
    change(material);
    REQUIRE_THROWS_WITH(check(material), Catch::Contains(says));
  };
  using Soil = TabulatedMohrCoulomb;
  refused([](Soil& m) { m.plastic_strain = {0.0}; }, "two numbers or more");
  refused([](Soil& m) { m.plastic_strain[0] = 0.01; }, "begin at 0");
  refused([](Soil& m) { m.plastic_strain[2] = 0.02; }, "must rise");
  refused([](Soil& m) { m.friction_angle = {30.0, 20.0}; }, "as many as plastic_strain, 3, got 2");
  refused([](Soil& m) { m.dilatancy_angle = {36.0}; }, "friction angle of 35");
  refused([](Soil& m) { m.cohesion[1] = -1.0; }, "cohesion");
}
