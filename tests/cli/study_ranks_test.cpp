#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/study_folder.h"

namespace {

/// What stands before the program, so that it runs in so many processes. Open MPI refuses to run
/// for the system's administrator, whom containers make of everybody, unless told twice.
std::string mpirun(int ranks) {
  return "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe "
         "-n " +
         std::to_string(ranks) + ' ';
}

const std::vector<std::string> kStudy = {"study", "study.toml", "--quiet",   "--out",
                                         "o",     "--resume",   "--threads", "1"};

}  // namespace

TEST_CASE("a study on 2 to 4 ranks leaves the bytes of one process") {
  const StudyFolder folder;
  folder.write_study(kSmallStudy);
  const Left whole = folder.run({"--out", "whole"});
  for (const int ranks : {2, 4}) {
    const Ended ended = run_spoke(kStudy, folder.work(), mpirun(ranks));
    CAPTURE(ended.err);
    CHECK(ended.status == 0);
    CHECK(folder.left_in("o") == whole);
    std::filesystem::remove_all(folder.work().path() / "o");
  }
}

TEST_CASE("a study whose rank is killed is resumed on any number of ranks to the same bytes") {
  const StudyFolder folder;
  std::string text = kSmallStudy;
  text.replace(text.find("[2, 4, 6]"), 9, "[2, 4, 2000]");
  folder.write_study(text);
  const Left whole = folder.run({"--out", "whole", "--threads", "1"});
  const std::string killed =
      mpirun(3) +
      "sh -c '[ $OMPI_COMM_WORLD_RANK != 2 ] || (sleep 0.2; kill -9 $$) & exec \"$0\" \"$@\"' ";
  const Ended ended = run_spoke(kStudy, folder.work(), killed);
  CHECK(ended.status != 0);
  const Ended resumed = run_spoke(kStudy, folder.work(), mpirun(2));
  CAPTURE(resumed.err);
  CHECK(resumed.status == 0);
  CHECK(folder.left_in("o") == whole);
}

TEST_CASE("what is wrong with a study is said by one rank") {
  const StudyFolder folder;
  folder.write_study("scenario = 3\n");
  const Ended ended = run_spoke(kStudy, folder.work(), mpirun(3));
  CHECK(ended.status == 2);
  const std::string message = "study.toml:1:12: scenario: is 3, expected text in quotes";
  CHECK(ended.err.find(message) != std::string::npos);
  CHECK(ended.err.find(message) == ended.err.rfind(message));
}
