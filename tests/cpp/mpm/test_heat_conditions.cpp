#include <catch2/catch.hpp>
#include <cmath>

#include "lapilli/mpm/heat/conditions/heat_boundary.hpp"

namespace lapilli {
namespace {

constexpr double hold = 7.0;  // W/(m^2 K)

struct Found {
  double rate, coefficient, tangent;
};

/// What a condition does at one site of this temperature over the first two seconds.
Found found(const HeatBoundary& condition, double state, double weight = 1.0, double zero = 0.0) {
  const Vec3 position{0.5, 0.0, 0.0};
  double rate = 0.0, coefficient = 0.0, target = 0.0, tangent = 0.0;
  const Exchange exchange{{&rate, 1}, {&coefficient, 1}, {&target, 1}, {&tangent, 1}};
  find_exchange(condition, {{&position, 1}, {&state, 1}, {&hold, 1}, {&weight, 1}, 0.0, 2.0, zero},
                exchange);
  if (surroundings_of(condition) != nullptr) {
    add_exchange(exchange, {&state, 1});
  }
  return {rate, coefficient, tangent};
}

/// 1000 - 2 T.
Value falling() {
  return ArrayFunction(
      [](std::span<const Vec3>, std::span<const double> state, double, std::span<double> values) {
        for (std::size_t k = 0; k < values.size(); ++k) {
          values[k] = 1000.0 - 2.0 * state[k];
        }
      });
}

Flux flux(Value value) {
  Flux condition;
  condition.value = std::move(value);
  return condition;
}

Convection convection(Value coefficient, Value ambient) {
  Convection condition;
  condition.coefficient = std::move(coefficient);
  condition.ambient = std::move(ambient);
  return condition;
}

Radiation radiation(double emissivity, double ambient) {
  Radiation condition;
  condition.emissivity = emissivity;
  condition.ambient = ambient;
  return condition;
}

PrescribedTemperature prescribed(Value value) {
  PrescribedTemperature condition;
  condition.value = std::move(value);
  return condition;
}

std::vector<HeatBoundary> samples() {
  const Table rising{{0.0, 2.0}, {300.0, 500.0}};
  return {flux(-30.0),
          flux(rising),
          flux(falling()),
          convection(5.0, 400.0),
          convection(Table{{0.0, 2.0}, {4.0, 6.0}}, 400.0),
          convection(5.0, rising),
          radiation(0.8, 900.0),
          prescribed(400.0),
          prescribed(rising)};
}

TEST_CASE("Rates of boundary conditions of heat are those of their equations") {
  const double temperature = 350.0, sigma = 5.670374419e-8;
  CHECK(found(flux(-30.0), temperature).rate == -30.0);
  CHECK(found(flux(falling()), temperature).rate == Approx(300.0));
  CHECK(found(convection(5.0, 400.0), temperature).rate == Approx(250.0));
  CHECK(found(prescribed(400.0), temperature).rate == Approx(hold * 50.0));
  CHECK(found(radiation(0.8, 900.0), temperature).rate ==
        Approx(0.8 * sigma * (std::pow(900.0, 4) - std::pow(350.0, 4))));
  // A table counts by its mean, that of the surroundings weighted by the coefficient: the ambient
  // falls from 400 to 0 K while the coefficient rises from 0 to 6, by thirds 400 / 3.
  const Value coefficient = Table{{0.0, 2.0}, {0.0, 6.0}};
  const Value ambient = Table{{0.0, 2.0}, {400.0, 0.0}};
  CHECK(found(convection(coefficient, ambient), 100.0).rate == Approx(3.0 * (400.0 / 3.0 - 100.0)));
}

TEST_CASE("What boundary conditions of heat say of themselves is what they do") {
  for (const HeatBoundary& condition : samples()) {
    INFO(name_of_law(condition, 0));
    const double near = 350.0, rise = 1e-3;
    const Found here = found(condition, near);
    // The tangent is the slope of the rate.
    const double slope =
        (found(condition, near - rise).rate - found(condition, near + rise).rate) / (2.0 * rise);
    CHECK(here.tangent == Approx(slope).epsilon(1e-6).margin(1e-6));
    // Without a function of the temperature, linear means one tangent everywhere.
    if (!has_function(condition)) {
      CHECK((found(condition, 700.0).tangent == here.tangent) == is_linear(condition));
    }
    // At the surroundings nothing is exchanged, and the secant leads there.
    if (const Value* surroundings = surroundings_of(condition)) {
      const double target = surroundings->mean(0.0, 2.0);
      CHECK(found(condition, target).rate == Approx(0.0).margin(1e-9));
      CHECK(near + here.rate / here.coefficient == Approx(target));
      CHECK(!key_of_surroundings(condition).empty());
    } else {
      CHECK(key_of_surroundings(condition).empty());
    }
    // The bound on the coefficient holds up to the hottest place.
    if (exchanges(condition)) {
      CHECK(found(condition, 800.0).coefficient <= largest_coefficient(condition, 800.0, 0.0));
    }
    if (const Value* given = given_coefficient(condition)) {
      CHECK(here.coefficient == given->mean(0.0, 2.0));
    }
    CHECK(holds_temperature(condition) == (here.coefficient == hold));
    // Weights are factors; powers of two round nothing.
    const Found weighted = found(condition, near, 0.25);
    CHECK(weighted.rate == 0.25 * here.rate);
    CHECK(weighted.coefficient == 0.25 * here.coefficient);
    CHECK(weighted.tangent == 0.25 * here.tangent);
  }
}

TEST_CASE("Radiation counts temperatures from absolute zero") {
  const Found kelvin = found(radiation(0.8, 900.0), 350.0);
  const Found celsius = found(radiation(0.8, 900.0 - 273.15), 350.0 - 273.15, 1.0, -273.15);
  CHECK(celsius.rate == Approx(kelvin.rate).epsilon(1e-12));
  CHECK(celsius.tangent == Approx(kelvin.tangent).epsilon(1e-12));
  CHECK(needs_absolute(radiation(0.8, 900.0)));
  CHECK(any_needs_absolute(samples()));
  CHECK(!needs_absolute(convection(5.0, 400.0)));
}

TEST_CASE("Lists of boundary conditions say what they hold") {
  CHECK(modelled_by({}).empty());
  const std::vector<const char*> all = modelled_by(samples());
  REQUIRE(all.size() == std::variant_size_v<HeatBoundary>);
  CHECK(std::string(all.front()) == "prescribed flux");
  CHECK(std::string(all.back()) == "prescribed temperature");
  CHECK(key_of_surroundings(radiation(1.0, 1.0)) == "ambient");
  CHECK(key_of_surroundings(prescribed(1.0)) == "value");
  CHECK(values_of(HeatBoundary(radiation(1.0, 1.0))).size() == 2);
  CHECK(!are_linear(samples()));
  CHECK(are_linear(std::vector<HeatBoundary>{flux(1.0), convection(5.0, falling())}));
  CHECK(is_uniform(convection(5.0, 400.0)));
  CHECK(!is_uniform(convection(5.0, falling())));
  CHECK(!is_uniform(radiation(1.0, 1.0)));
}

}  // namespace
}  // namespace lapilli
