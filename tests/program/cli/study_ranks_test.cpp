// spoke study under mpirun: the files of one process.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/program/cli/rank_kills.h"
#include "tests/program/cli/study_folder.h"

TEST_CASE("a study on 2 to 4 ranks leaves the bytes of one process") {
  const StudyFolder folder;
  folder.write_study(std::string(kSmallStudy) + "\n[statistics]\n");
  const Left whole = folder.run({"--out", "whole"});
  for (const int ranks : {2, 4}) {
    const Ended ended = run_spoke(kStudyOnRanks, folder.work(), mpirun(ranks));
    CAPTURE(ended.err);
    CHECK(ended.status == 0);
    CHECK(folder.left_in("o") == whole);
    std::filesystem::remove_all(folder.work().path() / "o");
  }
}

TEST_CASE("a study whose ranks are killed is resumed to the bytes of one process") {
  check_rank_kills(2, 1000);
}
