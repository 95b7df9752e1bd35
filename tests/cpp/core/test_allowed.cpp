#include <catch2/catch.hpp>
#include <limits>

#include "lapilli/core/allowed.hpp"

using namespace lapilli;
using Catch::Matchers::Equals;

TEST_CASE("a range is said in words") {
  CHECK(allowed_range(Key("a")).empty());
  CHECK(allowed_range(Key("a").unit("m").positive()) == "above 0 (m)");
  CHECK(allowed_range(Key("a").non_negative()) == "at least 0");
  CHECK(allowed_range(Key("a").range(0.5, 1.0)) == "from 0.5 to 1");
  CHECK(allowed_range(Key("a").range(0.0, 1.0, true)) == "above 0 and at most 1");
}

TEST_CASE("a number out of range names the place, the range and itself") {
  const Key cell = Key("cell").unit("m").positive();
  CHECK_NOTHROW(check_range(cell, 0.1, "grid"));
  CHECK_THROWS_WITH(check_range(cell, -1.0, "grid"),
                    Equals("grid: cell must be above 0 (m), got -1"));
  CHECK_THROWS(check_range(cell, 0.0, "grid"));
  CHECK_THROWS(check_range(cell, std::numeric_limits<double>::quiet_NaN(), "grid"));
  CHECK_THROWS_WITH(check_range(Key("x"), std::numeric_limits<double>::infinity(), ""),
                    Equals("x must be a finite number, got inf"));
  CHECK_NOTHROW(check_range(Key("x").range(0, 1), 0.0, ""));
  CHECK_THROWS(check_range(Key("x").range(0, 1, true), 0.0, ""));
}

TEST_CASE("the nearest name is found through typing slips") {
  const std::vector<std::string> keys = {"density", "specific_heat", "conductivity"};
  CHECK(nearest_name("desnity", keys) == "density");
  CHECK(nearest_name("conductivty", keys) == "conductivity");
  CHECK(nearest_name("specific heat", keys) == "specific_heat");
  CHECK(nearest_name("viscosity_of_air", keys).empty());
  CHECK(unknown_name("key", "densty", keys) == "unknown key 'densty'; did you mean 'density'?");
  CHECK(unknown_name("key", "zzz", {"a", "b"}) == "unknown key 'zzz'; there is: a, b");
}
