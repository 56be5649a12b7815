#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

#include "models/error.h"
#include "models/reader/toml_document.h"
#include "models/reader/toml_section.h"
#include "tests/message_of.h"

using spoke::InputError;
using spoke::Quantity;
using spoke::TomlDocument;
using spoke::TomlSection;
using spoke::test::message_of;

TEST_CASE("numbers are read with integers accepted for floats") {
  const TomlDocument document("a = 3\nb = 2.5\nc = [1, 2.5]", "f.toml");
  const TomlSection root(document, {"a", "b", "c", "d"});
  CHECK(root.number("a", Quantity::any("m")) == 3.0);
  CHECK(root.number("b", Quantity::positive("m")) == 2.5);
  CHECK(root.number("d", Quantity::any("m"), 7.0) == 7.0);
  CHECK(root.integer("a", {1, 3}) == 3);
  CHECK(root.numbers("c", Quantity::any("m")) == std::vector<double>{1.0, 2.5});
}

TEST_CASE("complaints name place and key and value and expectation") {
  const TomlDocument document("[a]\n  x = -1\n  y = [1, \"two\"]\n", "f.toml");
  const TomlSection a = TomlSection(document, {"a"}).section("a", {"x", "y", "z"});
  CHECK(message_of([&] { a.number("x", Quantity::positive("m")); }) ==
        "f.toml:2:7: a.x: is -1, expected a number greater than 0 (m)");
  CHECK(message_of([&] { a.number("z", Quantity::between(0.0, 1.0)); }) ==
        "f.toml:1:1: a.z: is missing, expected a number from 0 to 1");
  CHECK(message_of([&] { a.numbers("y", Quantity::any("s")); }) ==
        "f.toml:3:11: a.y.2: is \"two\", expected a number (s)");
  CHECK(message_of([&] {
          a.integer("x", {1, 9});
        }) == "f.toml:2:7: a.x: is -1, expected a whole number from 1 to 9");
  CHECK(message_of([&] { a.text("x", ""); }) == "f.toml:2:7: a.x: is -1, expected text in quotes");
  CHECK(message_of([&] { a.flag("x", true); }) == "f.toml:2:7: a.x: is -1, expected true or false");
}

TEST_CASE("the first unknown key of a table is reported with the nearest known one") {
  const TomlDocument document("zeta = 1\nalpah = 2\n", "f.toml");
  CHECK(message_of([&] {
          TomlSection(document, {"alpha", "beta"});
        }) == "f.toml:1:1: zeta: unknown key, did you mean \"beta\"?");
  CHECK(message_of([&] {
          TomlSection(document, {"alpha", "zeta"});
        }) == "f.toml:2:1: alpah: unknown key, did you mean \"alpha\"?");
  CHECK(message_of([&] {
          TomlSection(document, {"alpah", "omega"});
        }) == "f.toml:1:1: zeta: unknown key, expected \"alpah\" or \"omega\"");
}

TEST_CASE("a missing table is read as an empty one and missing tables as none") {
  const TomlDocument document("a = 1", "f.toml");
  const TomlSection root(document, {"a", "b", "c"});
  CHECK(root.section("b", {"x"}).number("x", Quantity::any(""), 4.0) == 4.0);
  CHECK(root.sections("c", {"x"}).empty());
  CHECK(message_of([&] { root.section("b", {"x"}).number("x", Quantity::any("")); }) ==
        "f.toml:1:1: b.x: is missing, expected a number");
}

TEST_CASE("overrides set values in tables and arrays and make what is missing") {
  TomlDocument document("[a]\nx = 1\n[[b]]\ny = 1\n[[b]]\ny = 2\n", "f.toml");
  for (const char* assignment :
       {"a.x=5", "a.word=chord", "a.text = \"two words\"", "b.2.y=7", "b.3.y=8", "c.d.e=true",
        "n.1.f=[0, 1]", "a.list=[1, 2]", "a.list.2=9", "a.expression=x=y"}) {
    document.set(assignment);
  }
  const TomlSection root(document, {"a", "b", "c", "n"});
  const TomlSection a = root.section("a", {"x", "y", "word", "text", "list", "expression"});
  CHECK(a.integer("x", {0, 9}) == 5);
  CHECK(a.text("word", "") == "chord");
  CHECK(a.text("text", "") == "two words");
  CHECK(a.text("expression", "") == "x=y");
  CHECK(a.numbers("list", Quantity::any("")) == std::vector{1.0, 9.0});
  std::vector<double> y;
  for (const TomlSection& b : root.sections("b", {"y"}))
    y.push_back(b.number("y", Quantity::any("")));
  CHECK(y == std::vector{1.0, 7.0, 8.0});
  CHECK(root.section("c", {"d"}).section("d", {"e"}).flag("e", false));
  CHECK(root.sections("n", {"f"})[0].numbers("f", Quantity::any("")) == std::vector{0.0, 1.0});
}

TEST_CASE("an override that cannot be is refused in its own words") {
  const auto refusal = [](const std::string& assignment) {
    return message_of([&] { TomlDocument("a = 1\nb = [1, 2]", "f.toml").set(assignment); });
  };
  CHECK(refusal("a").starts_with("--set a: has no '='"));
  CHECK(refusal("=3").starts_with("--set =3: the key is \"\", expected names"));
  CHECK(refusal("x..y=3").starts_with("--set x..y=3: the key is \"x..y\", expected names"));
  CHECK(refusal("x.=3").starts_with("--set x.=3: the key is \"x.\", expected names"));
  CHECK(refusal("x y=3").starts_with("--set x y=3: the key is \"x y\", expected names"));
  CHECK(refusal("x=").starts_with("--set x=: has no value"));
  CHECK(refusal("a.c=3") == "--set a.c=3: a: is 1, which holds no keys");
  CHECK(refusal("a.c.d=3") == "--set a.c.d=3: a: is 1, which holds no keys");
  CHECK(refusal("b.4=3") ==
        "--set b.4=3: b: is an array of 2 values, expected an index from 1 to 3 instead of \"4\"");
  CHECK(refusal("b.0=3").find("instead of \"0\"") != std::string::npos);
  CHECK(refusal("b.x=3").find("instead of \"x\"") != std::string::npos);
  CHECK(refusal("b.99999999999999999999=3").find("index from 1 to 3") != std::string::npos);
  CHECK(refusal("a.b.c.d.e.f.g.h.i=3").find("expected names") != std::string::npos);
}

TEST_CASE("a complaint about an overridden value quotes the override") {
  TomlDocument document("[a]\nx = 1\ny = 1", "f.toml");
  document.set("a.x=-8");
  document.set("b.1.z=1");
  const TomlSection root(document, {"a", "b"});
  const TomlSection a = root.section("a", {"x", "y"});
  CHECK(message_of([&] { a.number("x", Quantity::positive("m")); }) ==
        "--set a.x=-8: a.x: is -8, expected a number greater than 0 (m)");
  CHECK(message_of([&] { a.fail("y", "is odd"); }) == "f.toml:3:5: a.y: is odd");
  CHECK(message_of([&] { root.section("b", {}); }).starts_with("--set b.1.z=1: b: is an array"));
  CHECK(message_of([&] {
          root.sections("b", {"z"})[0].number("w", Quantity::any(""));
        }).starts_with("--set b.1.z=1: b.1.w: is missing"));
}

TEST_CASE("an override cannot smuggle in a second key or a second line") {
  TomlDocument document("a = 1", "f.toml");
  document.set("a=2\nb=3");
  // A second key would be refused: only "a" is known.
  CHECK(TomlSection(document, {"a"}).text("a", "") == "2 b=3");
}

TEST_CASE("messages have one line whatever the file holds") {
  const TomlDocument document("\"a\\nb\" = 1\nc = \"x\\ny\"", "f.toml");
  CHECK(message_of([&] { TomlSection(document, {"c"}); }).find('\n') == std::string::npos);
  const TomlSection root(document, {"a\nb", "c"});
  CHECK(message_of([&] { root.number("c", Quantity::any("")); }) ==
        "f.toml:2:5: c: is \"x y\", expected a number");
}
