#include "engine/support/json.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <exception>
#include <limits>
#include <string>
#include <vector>

using spoke::Json;

TEST_CASE("json: objects keep the order of their members") {
  Json json{{"z", 1}, {"a", Json::array({true, nullptr, "text"})}, {"inner", {{"b", 2}, {"a", 3}}}};
  CHECK(json.dump() == R"({"z":1,"a":[true,null,"text"],"inner":{"b":2,"a":3}})");
  json.set("z", "again");
  json.update({{"last", 4}, {"a", 5}});
  CHECK(json.dump() == R"({"z":"again","a":5,"inner":{"b":2,"a":3},"last":4})");
  CHECK(Json{{"only", Json::object()}}.dump_lines() == "{\n  \"only\": {}\n}\n");
}

TEST_CASE("json: numbers are whole or read back as they were, others are null") {
  CHECK(Json(std::numeric_limits<std::uint64_t>::max()).dump() == "18446744073709551615");
  CHECK(Json(std::numeric_limits<std::int64_t>::min()).dump() == "-9223372036854775808");
  CHECK(std::stod(Json(0.1).dump()) == 0.1);
  CHECK(Json(std::vector<double>{0.5, std::numeric_limits<double>::infinity()}).dump() ==
        "[0.5,null]");
  CHECK(Json(std::numeric_limits<double>::quiet_NaN()).dump() == "null");
  CHECK(Json(std::vector<int>{}).dump() == "[]");
}

TEST_CASE("json: any bytes make a valid text") {
  CHECK(Json("a\xff\"b").dump() == "\"a\xef\xbf\xbd\\\"b\"");
  CHECK(Json{{"a \\ key", "a\nline"}}.dump() == R"({"a \\ key":"a\nline"})");
  CHECK_THROWS_AS(Json::parse("{"), std::exception);
  CHECK(Json::parse(R"({"b": 1, "a": [2]})").dump() == R"({"b":1,"a":[2]})");
}

TEST_CASE("json: copies share nothing") {
  Json one = Json::array({1});
  Json other = one;
  other.push_back(2);
  CHECK(one.dump() == "[1]");
  CHECK(other.dump() == "[1,2]");
}
