// spoke run under mpirun: one model in several processes, with the files of one process.

#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// The summary without what depends on time and machine.
json figures_in(const fs::path& folder) {
  json summary = json::parse(read_file(folder / "summary.json"));
  for (const char* field : {"wall_time_s", "threads", "processes", "machine", "executor_choice"})
    summary.erase(field);
  return summary;
}

std::vector<std::string> command(const std::string& scenario, const std::string& duration,
                                 const std::vector<std::string>& further) {
  std::vector<std::string> words{
      "run", shipped(scenario), "--quiet", "--set", "integration.duration=" + duration, "--threads",
      "1"};
  words.insert(words.end(), further.begin(), further.end());
  return words;
}

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

}  // namespace

TEST_CASE("a run in several processes writes the bytes of one process") {
  const WorkFolder folder;
  const auto check = [&](const std::string& scenario, const std::string& duration, int ranks) {
    CAPTURE(scenario);
    const Ended alone = run_spoke(command(scenario, duration, {"--out", "alone"}), folder);
    const Ended shared =
        run_spoke(command(scenario, duration, {"--out", "shared", "--vtk"}), folder, mpirun(ranks));
    CAPTURE(shared.err);
    CHECK(alone.status == 0);
    CHECK(shared.status == 0);
    const fs::path one = folder.path() / "alone", all = folder.path() / "shared";
    CHECK(read_file(one / "sensors.csv") == read_file(all / "sensors.csv"));
    CHECK(figures_in(one) == figures_in(all));
    CHECK(json::parse(read_file(all / "summary.json"))["processes"] == ranks);
    CHECK(fs::exists(all / "report.html"));
    CHECK(fs::exists(all / "vtk"));
  };
  check("wu_haug_rotor", "2", 2);
  check("satellite_booms", "1", 3);
}

TEST_CASE("a run in several processes that diverges says so once") {
  const WorkFolder folder;
  const std::vector<std::string> diverging =
      command("wu_haug_rotor", "2", {"--integrator", "rk4", "--out", "o"});
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
    const Ended ended = run_spoke(command("wu_haug_rotor", "1", options), folder, mpirun(ranks));
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
  run_spoke(command(scenario, "300", {"--out", "whole"}), folder);
  const std::vector<std::string> options{"--out", "o", "--checkpoint-every", "1000"};
  const std::string interrupted =
      mpirun(3) +
      "sh -c '[ $OMPI_COMM_WORLD_RANK != 0 ] || (until [ -e o/sensors.csv ]; do sleep 0.05; done; "
      "sleep 0.3; kill -TERM $$) & exec \"$0\" \"$@\"' ";
  const Ended ended = run_spoke(command(scenario, "300", options), folder, interrupted);
  CAPTURE(ended.err);
  CHECK(ended.status == 143);
  CHECK(count_of("interrupted by SIGTERM", ended.err) == 1);
  const Ended resumed =
      run_spoke(command(scenario, "300", {"--resume", "o/checkpoint.spoke"}), folder, mpirun(2));
  CAPTURE(resumed.err);
  CHECK(resumed.status == 0);
  const fs::path whole = folder.path() / "whole", o = folder.path() / "o";
  CHECK(read_file(o / "sensors.csv") == read_file(whole / "sensors.csv"));
  CHECK(figures_in(o) == figures_in(whole));
}
