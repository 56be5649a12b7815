// Runs under mpirun that are refused, diverge or are ended; mpirun takes a second to notice.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"
#include "tests/program/cli/rank_kills.h"
#include "tests/program/cli/run_ranks.h"
#include "tests/program/cli/study_folder.h"

namespace fs = std::filesystem;

TEST_CASE("a run in several processes that diverges says so once") {
  const WorkFolder folder;
  const std::vector<std::string> diverging =
      run_of("wu_haug_rotor", "2", {"--integrator", "rk4", "--out", "o"});
  const Ended alone = run_spoke(diverging, folder);
  const std::string rows = file_text(folder.path() / "o" / "sensors.csv");
  const Ended shared = run_spoke(diverging, folder, mpirun(3));
  CHECK(alone.status == 3);
  CHECK(shared.status == 3);
  CHECK(count_of(lines_of(alone.err).back(), shared.err) == 1);
  CHECK(file_text(folder.path() / "o" / "sensors.csv") == rows);
}

TEST_CASE("what several processes cannot do is refused by one of them, and nothing written") {
  const WorkFolder folder;
  const auto check = [&](const std::vector<std::string>& options, int ranks,
                         const std::string& message) {
    const Ended ended = run_spoke(run_of("wu_haug_rotor", "1", options), folder, mpirun(ranks));
    CAPTURE(ended.err);
    CHECK(ended.status == 2);
    CHECK(count_of(message, ended.err) == 1);
    CHECK(folder.entries() == 0);
  };
  check({"--trace", "t"}, 2, "--trace: several processes make the run together, expected one");
  check({"--formulation", "augmented"}, 2, "expected structured or subsystem");
  check({}, 4, "it has 3 subsystems, expected at most so many processes");
}

TEST_CASE("a run in several processes that is interrupted is resumed by any number of them") {
  const WorkFolder folder;
  const std::string scenario = "satellite_booms";
  run_spoke(run_of(scenario, "120", {"--out", "whole"}), folder);
  const std::vector<std::string> options{"--out", "o", "--checkpoint-every", "1000"};
  const std::string interrupted =
      mpirun(3) +
      "sh -c '[ $OMPI_COMM_WORLD_RANK != 0 ] || (until [ -e o/sensors.csv ]; do sleep 0.05; done; "
      "sleep 0.1; kill -TERM $$) & exec \"$0\" \"$@\"' ";
  const Ended ended = run_spoke(run_of(scenario, "120", options), folder, interrupted);
  CAPTURE(ended.err);
  CHECK(ended.status == 143);
  CHECK(count_of("interrupted by SIGTERM", ended.err) == 1);
  const Ended resumed =
      run_spoke(run_of(scenario, "120", {"--resume", "o/checkpoint.spoke"}), folder, mpirun(2));
  CAPTURE(resumed.err);
  CHECK(resumed.status == 0);
  const fs::path whole = folder.path() / "whole", o = folder.path() / "o";
  CHECK(file_text(o / "sensors.csv") == file_text(whole / "sensors.csv"));
  CHECK(figures_in(o) == figures_in(whole));
}

TEST_CASE("a run of which a process is killed is resumed by another number of them") {
  const WorkFolder folder;
  const std::string scenario = "articulated_rotor", duration = "6";
  run_spoke(run_of(scenario, duration, {"--out", "whole"}), folder);
  const fs::path whole = folder.path() / "whole", o = folder.path() / "o";
  for (const int ranks : {2, 4, 3}) {
    // Each time behind another checkpoint.
    const std::string killing =
        mpirun(ranks) +
        "sh -c '[ $OMPI_COMM_WORLD_RANK != 1 ] || (touch begun; until [ o/checkpoint.spoke "
        "-nt begun ]; do sleep 0.02; done; kill -9 $$) & exec \"$0\" \"$@\"' ";
    const std::vector<std::string> from =
        fs::exists(o) ? std::vector<std::string>{"--resume", "o/checkpoint.spoke"}
                      : std::vector<std::string>{"--out", "o"};
    std::vector<std::string> options{"--checkpoint-every", "0.1"};
    options.insert(options.end(), from.begin(), from.end());
    const Ended ended = run_spoke(run_of(scenario, duration, options), folder, killing);
    CAPTURE(ended.err);
    CHECK(ended.status == kKilled);
    REQUIRE(fs::exists(o / "checkpoint.spoke"));
  }
  const Ended resumed =
      run_spoke(run_of(scenario, duration, {"--resume", "o/checkpoint.spoke"}), folder, mpirun(2));
  CAPTURE(resumed.err);
  CHECK(resumed.status == 0);
  CHECK(file_text(o / "sensors.csv") == file_text(whole / "sensors.csv"));
  CHECK(figures_in(o) == figures_in(whole));
}

TEST_CASE("what is wrong with a study is said by one rank") {
  const StudyFolder folder;
  folder.write_study("scenario = 3\n");
  const Ended ended = run_spoke(kStudyOnRanks, folder.work(), mpirun(3));
  CHECK(ended.status == 2);
  const std::string message = "study.toml:1:12: scenario: is 3, expected text in quotes";
  CHECK(ended.err.find(message) != std::string::npos);
  CHECK(ended.err.find(message) == ended.err.rfind(message));
}
