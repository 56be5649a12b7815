// spoke verify: files, choice of cases, and the status that tells whether they hold.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/contains.h"
#include "tests/program/cli/refusal.h"

using spoke::test::contains;

namespace {

/// Writes a case of a user's own: a rod of one metre that swings, with its period.
void write_case(const std::filesystem::path& folder, const std::string& period) {
  std::filesystem::create_directories(folder / "cases");
  std::ofstream(folder / "cases/mine.toml")
      << "group = \"Mine\"\n[[case]]\nname = \"rod\"\ntitle = \"A rod.\"\nsource = \"me\"\n"
         "by = \"an integral\"\nscenario = \"pendulum\"\nset = [\"integration.duration=5.0\"]\n"
         "analysis = \"run\"\nfigure = [{ name = \"period\", quantity = \"period\", of = "
         "\"pendulum.hinge\", unit = \"s\", error = 1e-5, exact = "
      << period << " }]\n";
}

}  // namespace

TEST_CASE("spoke verify writes what it finds, and scenarios that run by hand") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"verify", "hinged_blade", "--out", "v"}, folder);
  CHECK(ended.err.empty());
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "all within their stated errors"));
  CHECK(contains(file_text(folder.path() / "v/verify.csv"), "hinged_blade,flap,rad/s,"));
  CHECK(contains(file_text(folder.path() / "v/verify.json"), "\"verdict\": \"holds\""));
  CHECK(contains(file_text(folder.path() / "v/verify.html"), "Rotating beams"));
  CHECK(run_spoke({"check", "v/scenarios/hinged_blade.toml"}, folder).status == 0);
  CHECK(run_spoke({"verify", "hinged_blade", "--out", "v"}, folder).status == 0);
  const Ended page = run_spoke({"verify", "hinged_blade", "--out", "v", "--markdown"}, folder);
  CHECK(contains(page.out, "| `hinged_blade` | lag [rad/s] |"));
}

TEST_CASE("spoke verify takes a user's cases, and ends with 3 if one is off") {
  const WorkFolder folder;
  write_case(folder.path() / "own", "1.933334854");
  CHECK(run_spoke({"verify", "--cases", "own", "--out", "v"}, folder).status == 0);
  write_case(folder.path() / "own", "1.94");
  const Ended off = run_spoke({"verify", "--cases", "own", "--out", "v"}, folder);
  CHECK(off.status == 3);
  CHECK(contains(off.out, "1 not within their stated errors"));
  CHECK(contains(file_text(folder.path() / "v/verify.csv"), ",off,"));
}

TEST_CASE("spoke verify refuses names that it does not know, and folders without cases") {
  check_refused({"verify", "beck_colum"},
                "there is no case or group \"beck_colum\", did you mean \"beck_column\"?");
  check_refused({"verify", "--list", "--markdown"}, "--list");
  check_refused({"verify", "--threads", "0"}, "--threads");
  const WorkFolder folder;
  std::ofstream(folder.path() / "v") << "mine";
  check_refused({"verify", "hinged_blade", "--out", "v"}, "v", folder);
  check_refused({"verify", "--cases", "none"}, "none: has no cases, expected files cases/*.toml");
}
