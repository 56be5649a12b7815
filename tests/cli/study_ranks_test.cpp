#include <doctest/doctest.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "tests/cli/study_folder.h"

namespace {

const std::vector<std::string> kStudy = {"study", "study.toml", "--quiet",   "--out",
                                         "o",     "--resume",   "--threads", "1"};

/// What mpirun starts so that one of the ranks is killed after a time.
std::string kill_rank(int rank, double seconds) {
  return "sh -c '[ $OMPI_COMM_WORLD_RANK != " + std::to_string(rank) + " ] || (sleep " +
         std::to_string(seconds) + "; kill -9 $$) & exec \"$0\" \"$@\"' ";
}

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

TEST_CASE("a study whose ranks are killed 20 times ends in the bytes of one process") {
  const StudyFolder folder;
  std::string text = kSmallStudy;
  text.replace(text.find("[2, 4, 6]"), 9, "[2, 4, 2000]");
  folder.write_study(text);
  const Left whole = folder.run({"--out", "whole", "--threads", "1"});
  std::mt19937 random(std::random_device{}());
  std::uniform_real_distribution<double> moment(0.0, 1.0);  // s, the study takes about as long
  int killed = 0;
  for (int number = 0; killed < 20; ++number) {
    REQUIRE(number < 400);
    const int ranks = 2 + number % 3, rank = static_cast<int>(random() % 3) % ranks;
    const Ended ended =
        run_spoke(kStudy, folder.work(), mpirun(ranks) + kill_rank(rank, moment(random)));
    if (ended.status != 0) {
      ++killed;
      continue;
    }
    CHECK(folder.left_in("o") == whole);
    std::filesystem::remove_all(folder.work().path() / "o");
  }
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
