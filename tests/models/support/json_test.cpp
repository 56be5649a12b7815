#include "models/support/json.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

using spoke::Json;
using spoke::JsonChange;

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
}

TEST_CASE("json: texts of any origin are read, to a depth that a stack holds") {
  CHECK(Json::parse(R"({"b": 1, "a": [2]})").dump() == R"({"b":1,"a":[2]})");
  CHECK(Json::parse("{}").is_object());
  CHECK_FALSE(Json::parse("[1]").is_object());
  CHECK(Json::parse("{").dump() == "null");
  CHECK(Json::parse(std::string(100000, '[') + std::string(100000, ']')).dump().size() < 100);
}

TEST_CASE("json: members come, grow and go") {
  Json json;
  json.append("list", 1);
  json.append("list", "two");
  json.set("b", true);
  json.set("a", {{"d", 1}, {"c", 2}});
  json.erase("b");
  json.erase("none");
  CHECK(json.dump() == R"({"list":[1,"two"],"a":{"d":1,"c":2}})");
  CHECK(json.dump_sorted() == R"({"a":{"c":2,"d":1},"list":[1,"two"]})");
}

TEST_CASE("json: the first change between two values is found") {
  const auto change = [](const char* before, const char* after) {
    return JsonChange::find_first(Json::parse(before), Json::parse(after));
  };
  CHECK_FALSE(change(R"({"a": 1, "b": 0.0})", R"({"b": -0.0, "a": 1})"));
  const auto number = change(R"({"a": [{"b": 1.5}]})", R"({"a": [{"b": 2.0}]})");
  REQUIRE(number);
  CHECK(number->place == "/a/0/b");
  CHECK(number->before == "1.5");
  CHECK(number->after == "2.0");
  const auto gone = change("{\"a\": \"\xc3\xa9\"}", "{}");
  REQUIRE(gone);
  CHECK(gone->before == R"("\u00e9")");
  CHECK(gone->after.empty());
  CHECK(change(R"({"a": [1]})", R"({"a": [1, 2]})")->place == "/a/-");
  CHECK(change("{}", "[]")->place.empty());
}

TEST_CASE("json: copies share nothing") {
  Json one = Json::array({1});
  Json other = one;
  other.push_back(2);
  CHECK(one.dump() == "[1]");
  CHECK(other.dump() == "[1,2]");
}
