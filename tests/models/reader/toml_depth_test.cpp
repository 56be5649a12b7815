#include "models/reader/toml_depth.h"

#include <doctest/doctest.h>

#include <string>

#include "models/error.h"
#include "models/scenario.h"
#include "tests/message_of.h"

using namespace spoke;
using spoke::test::message_of;

namespace {

/// Returns "a.a. ... .a".
std::string dotted(std::size_t names) {
  std::string key = "a";
  for (std::size_t k = 1; k < names; ++k) key += ".a";
  return key;
}

}  // namespace

TEST_CASE("keys are counted by their names, wherever they stand") {
  CHECK_FALSE(find_deep_key("", 1));
  CHECK_FALSE(find_deep_key(dotted(4) + " = 1", 4));
  CHECK(find_deep_key(dotted(5) + " = 1", 4) == 7);
  for (const std::string text :
       {"[a.a.a]", "x = 1\n[[a . a\t.\"b\".c]]", "x = {a.a.a = 1}", "x = [1, {y = 2, a.'a'.a = 1}]",
        "\"=\".\"=\".a = 1", "x = \"\"\"a\n\"\"\"\"\", a.a.a", "x = \"\\\"\", a.a.a",
        "x = '\\', a.a.a", "x = '''a''''\na.a.a = 1", "# '\na.a.a = 1"}) {
    CAPTURE(text);
    CHECK(find_deep_key(text, 2));
    CHECK_FALSE(find_deep_key(text, 4));
  }
}

TEST_CASE("dots of numbers, texts and comments are no names") {
  for (const std::string text :
       {"x = [1.0, 2.0, 3.0,\n4.0, 5.0]", "x = 1.0 # a.a.a.a", "x = \"a.a.a.a\"", "x = 'a.a.a.a'",
        "x = \"\"\"a\n.a.a.a\"\"\"", "x = '''a\n.a.a.a'''", "x = \"a\\\".a.a.a\"",
        "\"a.a.a.a\" = 1", "x = \"\"\"\"a.a.a.a\"\"\"", "x = \"a.a.a", "x = \"\"\"a.a.a"}) {
    CAPTURE(text);
    CHECK_FALSE(find_deep_key(text, 2));
  }
}

TEST_CASE("a scenario of endlessly nested tables is refused") {
  const std::string deep = dotted(200'000);
  const std::string reason =
      "has a key of more than 32 names, expected at most that many, joined by dots";
  CHECK(message_of([&] { parse_scenario("title = 1\n" + deep + " = 1", "f.toml"); }) ==
        "f.toml:2:64: " + reason);
  CHECK(message_of([&] { parse_scenario('[' + deep + ']', "f.toml"); }) ==
        "f.toml:1:65: " + reason);
  CHECK(message_of([&] {
          parse_scenario("", "f.toml", {"hub={" + deep + "=1}"});
        }).find("expected a table [hub]") != std::string::npos);
  // As deep as keys and inline tables go together, to be parsed and destroyed.
  std::string text = "x = ";
  for (int k = 0; k < 250; ++k) text += '{' + dotted(32) + " = ";
  text += '1' + std::string(250, '}');
  CHECK(message_of([&] {
          parse_scenario('[' + dotted(32) + "]\n" + text, "f.toml");
        }).find("f.toml:1:2: a: unknown key") == 0);
}
