// spoke run under mpirun that is refused, diverges, or is ended. mpirun takes a second to notice.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/cli/run_ranks.h"

namespace fs = std::filesystem;

TEST_CASE("a run in several processes that diverges says so once") {
  const WorkFolder folder;
  const std::vector<std::string> diverging =
      run_of("wu_haug_rotor", "2", {"--integrator", "rk4", "--out", "o"});
  const Ended alone = run_spoke(diverging, folder);
  const std::string rows = read_file(folder.path() / "o" / "sensors.csv");
  const Ended shared = run_spoke(diverging, folder, mpirun(3));
  CHECK(alone.status == 3);
  CHECK(shared.status == 3);
  CHECK(count_of(lines_of(alone.err).back(), shared.err) == 1);
  CHECK(read_file(folder.path() / "o" / "sensors.csv") == rows);
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
  run_spoke(run_of(scenario, "300", {"--out", "whole"}), folder);
  const std::vector<std::string> options{"--out", "o", "--checkpoint-every", "1000"};
  const std::string interrupted =
      mpirun(3) +
      "sh -c '[ $OMPI_COMM_WORLD_RANK != 0 ] || (until [ -e o/sensors.csv ]; do sleep 0.05; done; "
      "sleep 0.3; kill -TERM $$) & exec \"$0\" \"$@\"' ";
  const Ended ended = run_spoke(run_of(scenario, "300", options), folder, interrupted);
  CAPTURE(ended.err);
  CHECK(ended.status == 143);
  CHECK(count_of("interrupted by SIGTERM", ended.err) == 1);
  const Ended resumed =
      run_spoke(run_of(scenario, "300", {"--resume", "o/checkpoint.spoke"}), folder, mpirun(2));
  CAPTURE(resumed.err);
  CHECK(resumed.status == 0);
  const fs::path whole = folder.path() / "whole", o = folder.path() / "o";
  CHECK(read_file(o / "sensors.csv") == read_file(whole / "sensors.csv"));
  CHECK(figures_in(o) == figures_in(whole));
}
