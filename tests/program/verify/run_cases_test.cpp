// The shipped cases are whole; cheap ones hold, and those that do not are told.

#include "program/verify/run_cases.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace spoke::verify {
namespace {

using test::message_of;

/// Writes the scenarios of cases to a folder, and runs them on two threads.
std::vector<CaseResult> run(const std::vector<Case>& cases) {
  const test::TemporaryFolder folder;
  for (const CaseFile& file : find_needed_files(cases, copy_shipped_files())) {
    const std::filesystem::path path = folder.path() / file.path;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << file.text;
  }
  std::size_t seen = 0;
  std::vector<CaseResult> results =
      run_cases(cases, folder.path(), 2, [&seen](std::size_t done) { seen = done; });
  CHECK(seen == cases.size());
  return results;
}

std::vector<Case> shipped(const std::vector<std::string>& names) {
  return choose_cases(read_all_cases(copy_shipped_files()), names);
}

}  // namespace

TEST_CASE("the shipped cases have sources, their scenarios, and are many") {
  const std::vector<CaseFile> files = copy_shipped_files();
  const std::vector<Case> cases = read_all_cases(files);
  CHECK(cases.size() >= 40);
  CHECK(!find_needed_files(cases, files).empty());
  for (const Case& one : cases) CHECK(!one.source.empty());
}

TEST_CASE("cheap cases hold: modes, a load, an equilibrium and a run") {
  for (const CaseResult& result :
       run(shipped({"hinged_blade", "simo_vu_quoc_extension", "epicyclic_gear"}))) {
    CAPTURE(result.of.name);
    CHECK(result.failure.empty());
    CHECK(result.holds());
  }
}

TEST_CASE("a figure that is off, and a case that fails, do not hold") {
  std::vector<Case> cases = shipped({"hinged_blade", "simo_vu_quoc_extension"});
  REQUIRE(cases.size() == 2);
  cases[0].figures[0].exact *= 1.0 + 1e-3;
  cases[1].figures[0].quantity = "tip w";
  const std::vector<CaseResult> results = run(cases);
  CHECK(results[0].failure.empty());
  CHECK_FALSE(results[0].holds());
  CHECK_FALSE(results[1].holds());
  CHECK(results[1].failure.find("quantity \"tip w\" is none of an equilibrium") !=
        std::string::npos);
  const Tally tally = count(results);
  CHECK(tally.figures == 3);
  CHECK(tally.held == 1);
  CHECK_FALSE(holds(cases[0].figures[0], std::numeric_limits<double>::quiet_NaN()));
}

TEST_CASE("cases are chosen by name or group, and a name that is neither is told") {
  CHECK(shipped({"Buckling and flutter"}).size() > 5);
  CHECK(message_of([] { shipped({"beck_colum"}); }) ==
        "there is no case or group \"beck_colum\", did you mean \"beck_column\"?");
}

}  // namespace spoke::verify
