#include <catch2/catch.hpp>
#include <cmath>

#include "lapilli/geometry/random.hpp"
#include "lapilli/materials/enthalpy.hpp"

using namespace lapilli;

namespace {

TemperatureTable table_at_random(Random& random) {
  TemperatureTable table;
  double at = random.uniform(-300.0, 300.0);
  const int entries = 1 + static_cast<int>(random.uniform(0.0, 6.0));
  for (int k = 0; k < entries; ++k) {
    table.temperatures.push_back(at);
    table.values.push_back(random.uniform(0.2, 5.0));
    at += random.uniform(1.0, 200.0);
  }
  return table;
}

/// The integral of a table from 0, by the trapezoidal rule between all its entries.
double integral(const TemperatureTable& table, double to) {
  constexpr int steps = 40000;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k) {
    sum += table.at(to * (k + 0.5) / steps) * to / steps;
  }
  return sum;
}

}  // namespace

TEST_CASE("enthalpy is the integral of the specific heat and gives its temperature back") {
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    Thermal material{random.uniform(0.5, 8000.0), table_at_random(random), 1.0, 0.0, {}, {}};
    if (trial % 3 > 0) {
      material.latent_heat = random.uniform(1.0, 500.0);
      material.solidus = random.uniform(-400.0, 600.0);
      material.liquidus = *material.solidus + (trial % 3 == 1 ? 0.0 : random.uniform(1e-6, 90.0));
    }
    check(material);
    const Enthalpy enthalpy(material);
    double before = -1e300;
    for (double at = -500.0; at < 900.0; at += random.uniform(1.0, 60.0)) {
      const double value = enthalpy.at(at);
      REQUIRE(value > before);
      before = value;
      const auto [temperature, slope] = enthalpy.place(value);
      REQUIRE(temperature == Approx(at).epsilon(1e-12).margin(1e-10));
      if (!material.solidus || at != *material.solidus) {
        REQUIRE(slope * enthalpy.slope(at) == Approx(1.0).epsilon(1e-8));
      }
    }
    if (trial % 30 == 0) {
      const double at = random.uniform(-500.0, 900.0);
      REQUIRE(
          enthalpy.at(at) - enthalpy.at(0.0) ==
          Approx(material.density * integral(*material.specific_heat.table(), at)).epsilon(1e-4));
    }
  }
}

TEST_CASE("melting at one temperature takes its latent heat there") {
  const Thermal ice{900.0, 2000.0, 2.0, 334e3, 0.0, {}};
  const Enthalpy enthalpy(ice);
  REQUIRE(enthalpy.at(0.0) == 0.0);
  REQUIRE(enthalpy.at(10.0) == Approx(900.0 * (2000.0 * 10.0 + 334e3)).epsilon(1e-14));
  REQUIRE(enthalpy.at(-10.0) == Approx(-900.0 * 2000.0 * 10.0).epsilon(1e-14));
  const double half = 0.5 * 900.0 * 334e3;
  REQUIRE(enthalpy.place(half).temperature == 0.0);
  REQUIRE(enthalpy.place(half).slope == 0.0);
  REQUIRE(enthalpy.liquid_fraction(0.0, half) == Approx(0.5).epsilon(1e-14));
  REQUIRE(enthalpy.liquid_fraction(1.0, enthalpy.at(1.0)) == 1.0);
  REQUIRE(enthalpy.liquid_fraction(-1.0, enthalpy.at(-1.0)) == 0.0);
}

TEST_CASE("Kirchhoff's potential of a line is its parabola") {
  Thermal material{1.0, 1.0, TemperatureTable{{0.0, 100.0}, {1.0, 3.0}}, 0.0, {}, {}};
  const RisingIntegral potential = kirchhoff_potential(material);
  for (double at : {-50.0, 0.0, 20.0, 100.0, 140.0}) {
    const double inside = std::min(std::max(at, 0.0), 100.0);
    const double exact =
        inside + 0.01 * inside * inside + std::min(at, 0.0) + 3.0 * std::max(0.0, at - 100.0);
    REQUIRE(potential.at(at) == Approx(exact / 3.0).epsilon(1e-14).margin(1e-14));
  }
}

TEST_CASE("tables and melting that cannot be are refused by name") {
  using Catch::Matchers::Contains;
  Thermal material{1.0, TemperatureTable{{1.0, 1.0}, {2.0, 3.0}}, 1.0, 0.0, {}, {}};
  REQUIRE_THROWS_WITH(check(material), Contains("specific_heat needs temperatures that rise"));
  material.specific_heat = TemperatureTable{{1.0, 2.0}, {2.0, 0.0}};
  REQUIRE_THROWS_WITH(check(material), Contains("specific_heat must be positive"));
  material.specific_heat = 1.0;
  material.conductivity = TemperatureTable{{1.0, 2.0}, {2.0, -1.0}};
  REQUIRE_THROWS_WITH(check(material), Contains("conductivity must be positive at every"));
  material.conductivity = 1.0;
  material.latent_heat = 5.0;
  REQUIRE_THROWS_WITH(check(material), Contains("latent_heat needs solidus"));
  material.solidus = 3.0;
  material.liquidus = 2.0;
  REQUIRE_THROWS_WITH(check(material), Contains("solidus 3 K lies above liquidus 2 K"));
  material.latent_heat = 0.0;
  material.liquidus.reset();
  REQUIRE_THROWS_WITH(check(material), Contains("need a latent_heat above 0"));
}
