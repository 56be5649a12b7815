// spoke new: scenarios to begin with, which run.

#include <doctest/doctest.h>

#include <string>

#include "tests/contains.h"
#include "tests/program/cli/refusal.h"

using spoke::test::contains;

TEST_CASE("spoke new writes scenarios that are valid and run, without a warning") {
  for (const std::string kind : {"rotor", "turbine", "helicopter", "mechanism", "part"}) {
    CAPTURE(kind);
    const WorkFolder folder;
    const Ended made = run_spoke({"new", kind, "my-first"}, folder);
    CHECK(made.err.empty());
    REQUIRE(made.status == 0);
    CHECK(contains(made.out, "spoke run my-first.toml"));
    CHECK(folder.entries() == (kind == "part" ? 2 : 1));
    const Ended checked = run_spoke({"check", "my-first.toml"}, folder);
    CHECK(checked.err.empty());
    CHECK(checked.status == 0);
    CHECK(contains(checked.out, "my-first"));
    CHECK_FALSE(contains(checked.out, "NAME"));
    const Ended ran = run_spoke(
        {"run", "my-first.toml", "--set", "integration.duration=0.2", "--executor", "serial"},
        folder);
    CHECK(ran.err.empty());
    CHECK(ran.status == 0);
  }
}

TEST_CASE("spoke new leaves files that are there, and says what it expects") {
  const WorkFolder folder;
  CHECK(run_spoke({"new", "rotor", "a.toml"}, folder).status == 0);
  const Ended again = run_spoke({"new", "turbine", "a"}, folder);
  CHECK(again.status == 2);
  CHECK(contains(again.err, "there is a file a.toml already, expected another name"));
  check_refused({"new", "car", "a"},
                "there is no kind \"car\", expected rotor, turbine, helicopter, mechanism or part");
  check_refused({"new", "rotor", "a b"}, "the name is \"a b\", expected letters, digits, _ and -");
}
