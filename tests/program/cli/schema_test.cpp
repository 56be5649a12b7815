// spoke schema: the keys of scenarios, for editors and as tables.

#include <doctest/doctest.h>

#include <string>

#include "tests/contains.h"
#include "tests/program/cli/refusal.h"

using spoke::test::contains;

TEST_CASE("spoke schema --json prints a JSON schema and nothing else") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"schema", "--json"}, folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(ended.out.starts_with("{\n  \"$schema\": \"http://json-schema.org/draft-07/schema#\""));
  CHECK(ended.out.ends_with("}\n"));
  CHECK(contains(ended.out, "\"inflow_factor\": {"));
  CHECK(folder.entries() == 0);
}

TEST_CASE("spoke schema --markdown prints tables") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"schema", "--markdown"}, folder);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "### [limits]\n\n| key of `[limits]` | meaning |"));
  CHECK(contains(ended.out, "| `density` | of the air | kg/m³ | 1.225 | greater than 0 |"));
}

TEST_CASE("spoke schema wants one form") {
  check_refused({"schema"}, "no form is given, expected --json or --markdown");
  check_refused({"schema", "--json", "--markdown"}, "--json");
}

TEST_CASE("spoke help explains a key, and names the nearest of one that is none") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"help", "air.density"}, folder);
  CHECK(ended.status == 0);
  CHECK(
      ended.out ==
      "density of [air]\n  of the air\n  unit     kg/m³\n  default  1.225\n  range    greater than "
      "0\n");
  check_refused({"help", "air.densty"},
                "scenarios have no key \"air.densty\", did you mean \"density\"?");
}
