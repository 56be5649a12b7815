#include "program/study/journal.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "tests/message_of.h"
#include "tests/program/study/studies.h"
#include "tests/temporary_folder.h"

using namespace spoke::study;
using spoke::test::make_study;
using spoke::test::message_of;

namespace fs = std::filesystem;

namespace {

RunResult some_result(std::int64_t run) {
  RunResult result;
  result.run = run;
  result.status = run == 2 ? RunStatus::diverged : RunStatus::done;
  result.diagnosis = run == 2 ? "diverged at t = 1" : "";
  result.responses = {0.1 * static_cast<double>(run)};
  result.histories = {{{0.0, 1.0}, {2.0, static_cast<double>(run)}}};
  return result;
}

/// Writes a journal of runs 3, 0 and 2 of 5.
void write_journal(const std::string& file, const Study& study) {
  Journal journal(file, study, Journal::Start::anew);
  for (const std::int64_t run : {3, 0, 2}) journal.append(some_result(run));
}

}  // namespace

TEST_CASE("a journal gives back the runs that it was given, also after a resumption") {
  const spoke::test::TemporaryFolder folder;
  const std::string file = folder / "study.journal";
  const Study study = make_study(DesignKind::sobol, 2, 0.0, 1.0, 5);
  write_journal(file, study);
  {
    Journal journal(file, study, Journal::Start::resumed);
    CHECK(journal.count() == 3);
    CHECK(journal.has(2));
    CHECK_FALSE(journal.has(1));
    const RunResult result = journal.read(2);
    CHECK(result.status == RunStatus::diverged);
    CHECK(result.diagnosis == "diverged at t = 1");
    CHECK(result.responses == std::vector<double>{0.2});
    CHECK(result.histories.at(0).values == std::vector<double>{2.0, 2.0});
    journal.append(some_result(1));
    journal.append(some_result(4));
    CHECK(journal.is_complete());
    CHECK(journal.read(4).responses == std::vector<double>{0.4});
  }
  CHECK(find_journal(file)->runs == 5);
  CHECK(find_journal(file)->planned == 5);
}

TEST_CASE("a record that was cut anywhere is none, and those before it stay") {
  const spoke::test::TemporaryFolder folder;
  const std::string file = folder / "study.journal", cut = folder / "cut.journal";
  const Study study = make_study(DesignKind::sobol, 2, 0.0, 1.0, 5);
  write_journal(file, study);
  const auto whole = fs::file_size(file);
  const auto record = (whole -
                       [&] {
                         const std::string empty = folder / "empty.journal";
                         Journal(empty, study, Journal::Start::anew);
                         return fs::file_size(empty);
                       }()) /
                      3;
  for (std::uintmax_t size = whole - record; size < whole; ++size) {
    fs::copy_file(file, cut, fs::copy_options::overwrite_existing);
    fs::resize_file(cut, size);
    Journal journal(cut, study, Journal::Start::resumed);
    CHECK(journal.count() == 2);
    CHECK_FALSE(journal.has(2));
    journal.append(some_result(2));
    CHECK(journal.read(2).diagnosis == "diverged at t = 1");
    CHECK(journal.read(0).responses == std::vector<double>{0.0});
  }
}

TEST_CASE("a journal of another study, or none, is refused") {
  const spoke::test::TemporaryFolder folder;
  const std::string file = folder / "study.journal";
  Study study = make_study(DesignKind::sobol, 2, 0.0, 1.0, 5);
  study.file = "a.toml";
  study.scenario_file = "rotor.toml";
  write_journal(file, study);
  const auto refusal = [&](const Study& other) {
    return message_of([&] { Journal(file, other, Journal::Start::resumed); });
  };
  Study other = study;
  other.text = "# changed";
  CHECK(refusal(other) == file +
                              ": is of another study, expected the same one to resume: a.toml is "
                              "not what it was");
  other = study;
  other.scenario_text = "# changed";
  CHECK(refusal(other).ends_with("rotor.toml is not what it was"));
  std::ofstream(file) << "once upon a time";
  CHECK(refusal(study) == file + ": is no journal of a study");
  CHECK_FALSE(find_journal(file));
}
