// Runs of a study that are made one after the other by one maker.

#include "program/study/single_run.h"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "program/study/journal.h"
#include "program/study/study_reader.h"
#include "tests/temporary_folder.h"

using namespace spoke::study;

namespace {

/// Speeds of the drive, of which one diverges, by lengths, of which one is refused.
const char* const kStudy = R"(
scenario = "rotor.toml"
design = { kind = "grid" }
[[parameter]]
key = "blade.length"
values = [3, -1, 4]
[[parameter]]
key = "hub.drive.speed"
values = [2, 1e6, 4, 4]
[[response]]
sensor = "blade1.tip.y"
kind = "min"
[[response]]
sensor = "energy.residual"
kind = "history"
)";

Study read_small_study(const spoke::test::TemporaryFolder& folder) {
  std::ofstream(folder / "rotor.toml") << R"(
[hub.drive]
kind = "spin_up"
speed = 4.0
ramp = 0.1
[blade]
count = 2
length = 3.0
bodies = 2
elements = 3
density = 2700.0
area = 7.3e-5
second_moment = 8.2e-9
youngs_modulus = 6.9e10
[integration]
step = 0.005
duration = 0.1
)";
  std::ofstream(folder / "study.toml") << kStudy;
  return read_study(folder / "study.toml");
}

}  // namespace

TEST_CASE("a run has the same bits whichever runs were made before it") {
  const spoke::test::TemporaryFolder folder;
  const Study study = read_small_study(folder);
  const Sampling sampling(study);
  RunMaker maker(study, sampling);
  int with_responses = 0, diverged = 0, refused = 0;
  for (std::int64_t run = 0; run < study.design.runs; ++run) {
    CAPTURE(run);
    const RunResult result = maker.make(run);
    CHECK(pack(result) == pack(RunMaker(study, sampling).make(run)));
    with_responses += result.has_responses() ? 1 : 0;
    diverged += result.status == RunStatus::diverged ? 1 : 0;
    refused += result.status == RunStatus::refused ? 1 : 0;
  }
  CHECK(with_responses == 6);
  CHECK(diverged == 2);
  CHECK(refused == 4);
}
