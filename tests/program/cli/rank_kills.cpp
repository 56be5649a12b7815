#include "tests/program/cli/rank_kills.h"

#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <random>

#include "tests/program/cli/study_folder.h"

const std::vector<std::string> kStudyOnRanks = {"study", "study.toml", "--quiet",   "--out",
                                                "o",     "--resume",   "--threads", "1"};

namespace {

/// Returns the command that mpirun starts so that one of the ranks is killed after a time.
std::string kill_rank(int rank, double seconds) {
  return "sh -c '[ $OMPI_COMM_WORLD_RANK != " + std::to_string(rank) + " ] || (sleep " +
         std::to_string(seconds) + "; kill -9 $$) & exec \"$0\" \"$@\"' ";
}

}  // namespace

void check_rank_kills(int kills, int runs) {
  const StudyFolder folder;
  std::string text = kSmallStudy;
  text.replace(text.find("[2, 4, 6]"), 9, "[2, 4, " + std::to_string(runs / 2) + "]");
  folder.write_study(text);
  const auto start = std::chrono::steady_clock::now();
  const Left whole = folder.run({"--out", "whole", "--threads", "1"});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::mt19937 random(std::random_device{}());
  std::uniform_real_distribution<double> moment(0.0, took.count());
  int killed = 0;
  for (int number = 0; killed < kills; ++number) {
    REQUIRE(number < 20 * kills);
    const int ranks = 2 + number % 3, rank = static_cast<int>(random() % 4) % ranks;
    const Ended ended =
        run_spoke(kStudyOnRanks, folder.work(), mpirun(ranks) + kill_rank(rank, moment(random)));
    if (ended.status != 0) {
      CAPTURE(ended.err);
      CHECK(ended.status == kKilled);
      ++killed;
      continue;
    }
    CHECK(folder.left_in("o") == whole);
    std::filesystem::remove_all(folder.work().path() / "o");
  }
  const Ended resumed = run_spoke(kStudyOnRanks, folder.work(), mpirun(2));
  CAPTURE(resumed.err);
  CHECK(resumed.status == 0);
  CHECK(folder.left_in("o") == whole);
}
