#include <catch2/catch.hpp>
#include <vector>

#include "lapilli/core/balance.hpp"

using namespace lapilli;

TEST_CASE("A residual is measured against the largest turnover or span so far") {
  Balance balance{"heat", "J", 100.0, 104.5, {{"convection", 5.0}, {"source", -1.0}}, 2.0};
  CHECK(balance.supplied() == 4.0);
  CHECK(balance.turnover() == 6.0);
  CHECK(balance.residual() == Approx(0.5 / 6.0));
  balance.largest = 50.0;
  CHECK(balance.residual() == Approx(0.01));
  // A body that has evened out spans nothing: the span it had counts.
  CHECK(Balance{"heat", "J", 1.0, 1.0 + 1e-13, {}, 0.0, 1.0, 2.0}.residual() ==
        Approx(0.5e-13).epsilon(0.01));
  CHECK(Balance{"heat", "J", 0.0, 0.0, {}}.residual() == 0.0);
}

TEST_CASE("Balances that pass their bar are named") {
  std::vector<Balance> balances{{"heat", "J", 1.0, 2.0, {{"flux 1", 1.0 + 1e-9}}, 0.0, 1e-6},
                                {"dynamics", "N s", 0.0, 1.0, {}, 1.0}};
  CHECK(open_balances(balances).empty());
  balances[0].entries[0].in = 0.9;
  CHECK_THAT(open_balances(balances), Catch::Contains("the balance of heat does not close") &&
                                          Catch::Contains("at most 1e-06 is allowed"));
  // What a large store rounds is no gap.
  balances[0] = {"heat", "J", 1e9, 1e9 + 1e-3, {{"flux 1", 1e-6}}, 0.0, 1e-6};
  CHECK(open_balances(balances).empty());
}
