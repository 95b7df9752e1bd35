#include <catch2/catch.hpp>
#include <cstdlib>
#include <limits>

#include "lapilli/output/json.hpp"

using namespace lapilli;

TEST_CASE("numbers are as short as reads back the same") {
  REQUIRE(shortest(0.1) == "0.1");
  REQUIRE(shortest(-0.0) == "-0");
  for (const double number :
       {1.0 / 3.0, 5e-324, 1.7976931348623157e308, 123456789.125, 0.1 + 0.2}) {
    REQUIRE(std::strtod(shortest(number).c_str(), nullptr) == number);
  }
}

TEST_CASE("objects and arrays nest with commas and indent") {
  JsonWriter json;
  json.begin_object();
  json.member("empty", "");
  json.key("list").begin_array();
  json.value(1);
  json.value(true);
  json.begin_object();
  json.end_object();
  json.end_array();
  json.key("made").json("{\"a\": 1}");
  json.end_object();
  REQUIRE(json.text() ==
          "{\n  \"empty\": \"\",\n  \"list\": [\n    1,\n    true,\n    {}\n  ],\n"
          "  \"made\": {\"a\": 1}\n}");
}

TEST_CASE("infinities become texts, and what is no number null") {
  JsonWriter json;
  json.begin_array();
  json.value(std::numeric_limits<double>::quiet_NaN());
  json.value(std::numeric_limits<double>::infinity());
  json.value(-std::numeric_limits<double>::infinity());
  json.end_array();
  REQUIRE(json.text() == "[\n  null,\n  \"inf\",\n  \"-inf\"\n]");
}

TEST_CASE("texts are escaped") {
  JsonWriter json;
  json.value("a \"quoted\" back\\slash\nnew\tline \x01 caf\xc3\xa9");
  REQUIRE(json.text() == "\"a \\\"quoted\\\" back\\\\slash\\nnew\\tline \\u0001 caf\xc3\xa9\"");
}
