#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "lapilli/core/value.hpp"

using namespace lapilli;

namespace {

/// Mean by a rule of many points, none of which lies on a time of the table.
double counted_mean(const Table& table, double begin, double end) {
  constexpr int parts = 100'003;
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) {
    sum += table.at(begin + (k + 0.5) / parts * (end - begin));
  }
  return sum / parts;
}

}  // namespace

TEST_CASE("a table jumps where two times are equal") {
  const Table table{{0.0, 1.0, 1.0, 3.0}, {2.0, 4.0, -1.0, 1.0}};
  CHECK(table.is_ordered());
  CHECK(table.before(1.0) == 4.0);
  CHECK(table.at(1.0) == -1.0);
  CHECK(table.at(2.0) == 0.0);
  CHECK(table.next_jump(-5.0) == 1.0);
  CHECK(std::isinf(table.next_jump(1.0)));
  CHECK_FALSE(Table{{0.0, 1.0, 1.0, 1.0}, {0.0, 0.0, 0.0, 0.0}}.is_ordered());
  CHECK_FALSE(Table{{1.0, 0.0}, {0.0, 0.0}}.is_ordered());
  // A jump at the very ends counts as well.
  CHECK(Table{{0.0, 0.0}, {1.0, 5.0}}.before(0.0) == 1.0);
  CHECK(Table{{0.0, 0.0}, {1.0, 5.0}}.at(0.0) == 5.0);
}

TEST_CASE("a mean over a span is that of the table, however short its pulses") {
  const Table pulse{{1.0, 1.0, 1.001, 1.001}, {0.0, 1000.0, 1000.0, 0.0}};
  CHECK(pulse.mean(0.0, 10.0) == Approx(0.1).epsilon(1e-12));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int draw = 0; draw < 40; ++draw) {
    Table table;
    double time = -1.0;
    for (int k = 0; k < 8; ++k) {
      const bool jumps = k > 1 && unit(random) < 0.3 && table.times[k - 1] > table.times[k - 2];
      time += jumps ? 0.0 : unit(random);
      table.times.push_back(time);
      table.values.push_back(2.0 * unit(random) - 1.0);
    }
    REQUIRE(table.is_ordered());
    const double begin = -2.0 + 4.0 * unit(random), end = begin + 3.0 * unit(random);
    CHECK(table.mean(begin, end) == Approx(counted_mean(table, begin, end)).margin(2e-4));
    // Means over parts add up.
    const double middle = begin + unit(random) * (end - begin);
    CHECK((middle - begin) * table.mean(begin, middle) + (end - middle) * table.mean(middle, end) ==
          Approx((end - begin) * table.mean(begin, end)).margin(1e-14));
  }
  CHECK(pulse.mean(2.0, 2.0) == 0.0);
  CHECK(Table{{0.0, 1.0}, {0.1, 0.1}}.mean(-0.3, 7.7) == 0.1);
}

TEST_CASE("the mean of a product is not the product of means") {
  const Value coefficient(Table{{0.5, 0.5}, {0.0, 2.0}}), ambient(Table{{0.0, 1.0}, {0.0, 1.0}});
  const double mean = mean_of_product({&coefficient, &ambient}, 0.0, 1.0, [&](double time) {
    return coefficient.at(time) * ambient.at(time);
  });
  CHECK(mean == Approx(0.75).epsilon(1e-14));
  // The fourth power of a ramp: 1/5, and a fifth degree is still exact.
  const auto power = [&](double time) { return time * std::pow(ambient.at(time), 4); };
  CHECK(mean_of_product({&ambient}, 0.0, 1.0, power) == Approx(1.0 / 6).epsilon(1e-14));
  CHECK(mean_of_product({&ambient}, 2.0, 3.0, [](double) { return 0.7; }) == 0.7);
}
