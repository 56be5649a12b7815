// Files of cases: what they say, and what is wrong with them.

#include "program/verify/case_reader.h"

#include <doctest/doctest.h>

#include <string>

#include "tests/message_of.h"

namespace spoke::verify {
namespace {

using test::message_of;

const std::string kHead =
    "group = \"Beams\"\n[[case]]\nname = \"one\"\ntitle = \"A beam.\"\nsource = \"Euler\"\n"
    "by = \"hand\"\nscenario = \"beam\"\n";

std::string refusal(const std::string& more) {
  return message_of([&] { read_cases(kHead + more, "c.toml"); });
}

}  // namespace

TEST_CASE("a case is read with its analysis and its figures") {
  const std::vector<Case> cases =
      read_cases(kHead +
                     "set = [\"blade.bodies=3\"]\nanalysis = \"critical\"\nvary = \"load=push\"\n"
                     "to = 3.0\npoints = 4\nfigure = [\n"
                     "  { name = \"load\", of = \"buckling\", exact = -2.0, error = 1e-3 },\n"
                     "  { name = \"frequency\", quantity = \"frequency\", exact = 0.0, "
                     "scale = 5.0, unit = \"Hz\", error = 1e-2 } ]\n",
                 "c.toml");
  REQUIRE(cases.size() == 1);
  const Case& one = cases[0];
  CHECK(one.group == "Beams");
  CHECK(one.overrides == Overrides{"blade.bodies=3"});
  CHECK(one.analysis.kind == AnalysisKind::critical);
  CHECK(one.analysis.critical.points == 4);
  REQUIRE(one.figures.size() == 2);
  CHECK(one.figures[0].quantity == "value");
  CHECK(one.figures[0].scale == 2.0);
  CHECK(one.figures[1].scale == 5.0);
  CHECK(command_of(one, "d/") ==
        "spoke critical d/beam.toml --of load=push --from 0 --to 3 --points 4 --set "
        "'blade.bodies=3'");
}

TEST_CASE("what is wrong with a case is said with its place") {
  CHECK(refusal("analysis = \"mode\"\n") ==
        "c.toml:8:12: case.1.analysis: is \"mode\", expected \"static\", \"modes\", \"critical\", "
        "\"performance\", \"linearize\" or \"run\"");
  CHECK(refusal("analysis = \"modes\"\n") ==
        "c.toml:2:1: case.1.figure: is missing, expected a number to compare with, or several");
  CHECK(refusal("analysis = \"modes\"\nwind = [8.0]\n") ==
        "c.toml:9:8: case.1.wind: does not go with \"modes\"");
  CHECK(refusal("analysis = \"modes\"\nfigure = [{ name = \"f\", exact = 1.0, error = 0.0 }]\n")
            .find("error: is 0.0, expected a number greater than 0") != std::string::npos);
  CHECK(refusal("analysis = \"modes\"\nfigure = [{ name = \"f\", exact = 0.0, error = 0.1 }]\n")
            .find("scale: is missing") != std::string::npos);
  CHECK(refusal("analysis = \"modes\"\nfigure = [{ name = \"f\", exact = 1.0, error = 0.1, unit = "
                "\"furlong\" }]\n")
            .find("unit: is \"furlong\"") != std::string::npos);
  CHECK(refusal("analysis = \"modes\"\nset = [3]\n").find("case.1.set.1: is 3, expected a text") !=
        std::string::npos);
}

}  // namespace spoke::verify
