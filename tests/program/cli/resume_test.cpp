// Checkpoints of a run, and runs that go on from them.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/checkpoint_checksum.h"
#include "tests/program/cli/program.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

using Words = std::vector<std::string>;

/// A run of so many seconds, of 200 steps each; what differs.
Words run_of(const std::string& seconds, const Words& more) {
  Words words = {"run",   shipped("wu_haug_rotor"), "--set",  "integration.duration=" + seconds,
                 "--set", "blade.bodies=2",         "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

json untimed_summary_in(const fs::path& folder) {
  json summary = json::parse(file_text(folder / "summary.json"));
  summary.erase("wall_time_s");
  return summary;
}

/// Checks that spoke refuses, in one line with `message`, and leaves the results as they are.
void check_refused_resume(const Words& words, const std::string& message,
                          const WorkFolder& folder) {
  const std::string rows = file_text(folder.path() / "o" / "sensors.csv");
  const int entries = folder.entries();
  const Ended ended = run_spoke(words, folder);
  CAPTURE(message);
  CAPTURE(ended.err);
  CHECK(ended.status == 2);
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(ended.err.find(message) != std::string::npos);
  CHECK(file_text(folder.path() / "o" / "sensors.csv") == rows);
  CHECK(folder.entries() == entries);
}

/// A finished run of one second in o/, with a checkpoint at its end.
void run_a_second(const WorkFolder& folder) {
  REQUIRE(run_spoke(run_of("1", {"--executor", "serial", "--out", "o", "--checkpoint-every", "9"}),
                    folder)
              .status == 0);
}

}  // namespace

TEST_CASE("a run goes on for longer, in its folder or another, as if it had not ended") {
  const WorkFolder folder;
  const Words serial = {"--executor", "serial"};
  // Not a multiple of the output interval: the last row is one that the longer run does not have.
  REQUIRE(
      run_spoke(run_of("1.02", {"--executor", "serial", "--out", "o", "--checkpoint-every", "100"}),
                folder)
          .status == 0);
  const Words statistics = {"--statistics-from", "0.5"};  // of rows before and after the checkpoint
  Words whole = run_of("2.04", {"--executor", "serial", "--out", "whole"});
  whole.insert(whole.end(), statistics.begin(), statistics.end());
  REQUIRE(run_spoke(whole, folder).status == 0);
  const std::string rows = file_text(folder.path() / "whole" / "sensors.csv");
  for (const Words& out : {Words{"--out", "other"}, Words{}}) {
    Words words = run_of("2.04", {"--executor", "serial", "--resume", "o/checkpoint.spoke"});
    words.insert(words.end(), out.begin(), out.end());
    words.insert(words.end(), statistics.begin(), statistics.end());
    const Ended ended = run_spoke(words, folder);
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    const fs::path results = folder.path() / (out.empty() ? "o" : "other");
    CHECK(file_text(results / "sensors.csv") == rows);
    CHECK(untimed_summary_in(results) == untimed_summary_in(folder.path() / "whole"));
  }
  CHECK(fs::exists(folder.path() / "o" / "checkpoint.spoke"));
  CHECK_FALSE(fs::exists(folder.path() / "other" / "checkpoint.spoke"));
}

TEST_CASE("a run resumed at its end has the same results again") {
  const WorkFolder folder;
  run_a_second(folder);
  const std::string rows = file_text(folder.path() / "o" / "sensors.csv");
  const json summary = untimed_summary_in(folder.path() / "o");
  const Ended ended =
      run_spoke(run_of("1", {"--executor", "serial", "--resume", "o/checkpoint.spoke"}), folder);
  CHECK(ended.status == 0);
  CHECK(file_text(folder.path() / "o" / "sensors.csv") == rows);
  CHECK(untimed_summary_in(folder.path() / "o") == summary);
}

TEST_CASE("checkpoints do not change the results, and a run without removes an old one") {
  const WorkFolder folder;
  REQUIRE(run_spoke(run_of("4", {"--out", "o", "--checkpoint-every", "0.001", "--set",
                                 "output.interval=0"}),
                    folder)
              .status == 0);
  const std::string rows = file_text(folder.path() / "o" / "sensors.csv");
  CHECK(fs::exists(folder.path() / "o" / "checkpoint.spoke"));
  REQUIRE(run_spoke(run_of("4", {"--out", "o", "--set", "output.interval=0"}), folder).status == 0);
  CHECK(file_text(folder.path() / "o" / "sensors.csv") == rows);
  CHECK(folder.entries() == 4);
}

TEST_CASE("a checkpoint that does not belong to the run is refused and nothing is changed") {
  const WorkFolder folder;
  run_a_second(folder);
  const Words resume = {"--resume", "o/checkpoint.spoke"};
  const auto with = [&](Words more) {
    more.insert(more.end(), resume.begin(), resume.end());
    return more;
  };
  check_refused_resume(
      run_of("2", with({"--set", "blade.length=7"})),
      "o/checkpoint.spoke: cannot be resumed: the saved state is of another model: "
      "blades.1.length is 8.0 in the saved state and 7.0 here",
      folder);
  check_refused_resume(
      run_of("2", with({"--integrator", "rk4"})),
      "integration.method is \"generalized_alpha\" in the saved state and \"rk4\" here", folder);
  check_refused_resume(run_of("2", with({"--formulation", "subsystem"})),
                       "formulation is \"structured\" in the saved state and \"subsystem\" here",
                       folder);
  check_refused_resume(run_of("2", with({"--set", "output.interval=0.1"})),
                       "output.interval is 0.05 in the checkpoint and 0.1 here", folder);
  check_refused_resume(run_of("0.5", with({})),
                       "it stands at t = 1 s, beyond the duration of 0.5 s", folder);
  check_refused_resume(run_of("2", {"--resume", "none"}), "none: cannot be read: No such file",
                       folder);
  check_refused_resume(run_of("2", {"--resume", "o/summary.json"}),
                       "o/summary.json: is no checkpoint of Spoke", folder);
}

TEST_CASE("a resumed run goes on with the rows of its sensors, and with no others") {
  const WorkFolder folder;
  const Words sensors = {"--set", "sensor.1={quantity=\"section_force\", position=3, name=\"mid\"}",
                         "--set",
                         "sensor.2={quantity=\"acceleration\", frame=\"inertial\", blade=2}"};
  const auto with = [&](const Words& more) {
    Words words = sensors;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  REQUIRE(run_spoke(run_of("1", with({"--out", "o", "--checkpoint-every", "9"})), folder).status ==
          0);
  REQUIRE(run_spoke(run_of("2", with({"--out", "whole"})), folder).status == 0);
  const std::string checkpoint = "o/checkpoint.spoke";
  check_refused_resume(
      run_of("2", with({"--set", "sensor.1.name=middle", "--resume", checkpoint})),
      "o/checkpoint.spoke: cannot be resumed: o/sensors.csv has other columns than the "
      "sensors of the scenario",
      folder);
  check_refused_resume(run_of("2", {"--resume", checkpoint}),
                       "it has records of 41 sensors and 3 tips, expected 29 and 3", folder);
  REQUIRE(run_spoke(run_of("2", with({"--resume", checkpoint})), folder).status == 0);
  const std::string rows = file_text(folder.path() / "o" / "sensors.csv");
  CHECK(rows == file_text(folder.path() / "whole" / "sensors.csv"));
  CHECK(
      rows.find(",blade3.root.moment,blade1.mid.x,blade1.mid.y,blade1.mid.moment,blade2.mid.x,") !=
      std::string::npos);
  CHECK(rows.find(",blade2.acceleration.x,blade2.acceleration.y,blade2.acceleration.rotation\n") !=
        std::string::npos);
}

TEST_CASE("a damaged checkpoint, and rows that are not its own, are refused") {
  const WorkFolder folder;
  run_a_second(folder);
  const fs::path results = folder.path() / "o";
  const std::string bytes = file_text(results / "checkpoint.spoke");
  const std::string rows = file_text(results / "sensors.csv");
  const Words words = run_of("2", {"--resume", "o/checkpoint.spoke"});
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(results / name, std::ios::binary) << text;
  };
  write("checkpoint.spoke", bytes.substr(0, bytes.size() - 7));
  check_refused_resume(words, "o/checkpoint.spoke: is truncated: has ", folder);
  std::string damaged = bytes;
  damaged[bytes.size() / 2] ^= 4;
  write("checkpoint.spoke", damaged);
  check_refused_resume(words, "o/checkpoint.spoke: is damaged: its checksum is ", folder);
  write("checkpoint.spoke", bytes);
  write("sensors.csv", rows.substr(0, rows.size() / 2));
  check_refused_resume(words, "o/sensors.csv: cannot be continued: it has ", folder);
  std::string other = rows;
  other[rows.size() / 2] = 'x';
  write("sensors.csv", other);
  check_refused_resume(words, "o/sensors.csv: cannot be continued: its first ", folder);
}

TEST_CASE("--checkpoint-every wants a time") {
  const WorkFolder folder;
  for (const char* seconds : {"0", "-1", "nan", "inf", "1e400", "soon", ""}) {
    const Ended ended = run_spoke(run_of("1", {"--checkpoint-every", seconds}), folder);
    CHECK(ended.status == 2);
    CHECK(ended.err.find("--checkpoint-every: expected a number above 0") != std::string::npos);
  }
  CHECK(run_spoke(run_of("0.1", {"--checkpoint-every", "1e300"}), folder).status == 0);
}

TEST_CASE("a column whose name begins as a formula does is none, and goes on when resumed") {
  const WorkFolder folder;
  const Words sensor = {"--set", "sensor.1={quantity=\"hub_reaction\", name=\"-a\"}"};
  const auto with = [&](Words more) {
    more.insert(more.end(), sensor.begin(), sensor.end());
    return more;
  };
  REQUIRE(run_spoke(run_of("1", with({"--out", "o", "--checkpoint-every", "9"})), folder).status ==
          0);
  const std::string head = lines_of(file_text(folder.path() / "o" / "sensors.csv")).front();
  CHECK(head.ends_with(",'-a.x,'-a.y,'-a.moment"));
  CHECK(json::parse(file_text(folder.path() / "o" / "summary.json"))["sensors"].contains("-a.x"));
  const Ended ended =
      run_spoke(run_of("2", with({"--out", "o", "--resume", "o/checkpoint.spoke"})), folder);
  CAPTURE(ended.err);
  CHECK(ended.status == 0);
}

namespace {

/// The bytes of a checkpoint with another version of Spoke, and a checksum that fits.
std::string with_other_version(std::string bytes) {
  constexpr std::size_t text = 8 + 4 + 8 + 8;  // behind magic, format, length and its own length
  bytes[text] = bytes[text] == '9' ? '8' : '9';
  return spoke::test::with_fitting_checksum(std::move(bytes));
}

}  // namespace

TEST_CASE("a checkpoint of another version is taken with a warning, which --quiet does not hide") {
  const WorkFolder folder;
  run_a_second(folder);
  const fs::path file = folder.path() / "o" / "checkpoint.spoke";
  const std::string bytes = with_other_version(file_text(file));
  std::ofstream(file, std::ios::binary) << bytes;
  const Ended ended =
      run_spoke(run_of("2", {"--executor", "serial", "--resume", "o/checkpoint.spoke"}), folder);
  CHECK(ended.status == 0);
  REQUIRE(lines_of(ended.err).size() == 1);
  CHECK(ended.err.starts_with("warning: o/checkpoint.spoke: written by Spoke "));
  CHECK(ended.err.ends_with(" the last bits may differ\n"));
}
