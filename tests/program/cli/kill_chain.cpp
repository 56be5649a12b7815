#include "tests/program/cli/kill_chain.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "tests/program/cli/child.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// Results of a run that must not depend on how often it was killed.
struct RunLeft {
  json summary;
  std::string rows;
};

RunLeft left_in(const fs::path& folder) {
  RunLeft left{json::parse(file_text(folder / "summary.json")), file_text(folder / "sensors.csv")};
  for (const char* field : {"wall_time_s", "executor", "executor_choice", "threads"})
    left.summary.erase(field);
  return left;
}

/// 4000 steps with a row each, and what differs from run to run.
std::vector<std::string> run_of(const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {
      "run", shipped("wu_haug_rotor"), "--set", "output.interval=0", "--out", "o", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<std::string> executor_of(int number) {
  if (number % 3 == 0) return {"--executor", "serial"};
  if (number % 3 == 1) return {"--executor", "flow_graph", "--threads", "2", "--window", "10"};
  return {"--threads", "2"};
}

/// Starts, or resumes what was killed.
std::vector<std::string> next_run(const fs::path& checkpoint, int number) {
  std::vector<std::string> arguments = run_of({"--checkpoint-every", "0.002"});
  const std::vector<std::string> executor = executor_of(number);
  arguments.insert(arguments.end(), executor.begin(), executor.end());
  if (fs::exists(checkpoint)) arguments.insert(arguments.end(), {"--resume", "o/checkpoint.spoke"});
  return arguments;
}

/// Whether a killed process left the file of LLVM's OpenMP runtime, which exists once that has
/// begun. It may keep a later process of that number from starting.
bool has_left_openmp(pid_t process, fs::file_time_type since) {
  std::error_code error;
  const auto written = fs::last_write_time(
      "/dev/shm/__KMP_REGISTERED_LIB_" + std::to_string(process) + "_" + std::to_string(getuid()),
      error);
  return !error && written >= since;
}

/// Waits until a file is there, or for a second.
void wait_for(const fs::path& file) {
  constexpr double kPoll = 0.0005;  // s
  for (int polls = 0; polls < 2000 && !fs::exists(file); ++polls) sleep_seconds(kPoll);
}

}  // namespace

void check_kills(int kills) {
  const WorkFolder whole, folder;
  const auto begin = fs::file_time_type::clock::now();
  const auto start = std::chrono::steady_clock::now();
  REQUIRE(Child(run_of({"--executor", "serial"}), whole).wait().status == 0);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const RunLeft expected = left_in(whole.path() / "o");
  const fs::path results = folder.path() / "o", checkpoint = results / "checkpoint.spoke";

  std::mt19937 random(std::random_device{}());
  std::uniform_real_distribution<double> moment(0.0, took.count());
  int killed = 0, resumed = 0;
  for (int number = 0; killed < kills || fs::exists(results); ++number) {
    REQUIRE(number < 20 * kills);
    resumed += fs::exists(checkpoint) ? 1 : 0;
    Child child(next_run(checkpoint, number), folder);
    if (killed < kills) {
      // Where chance has killed all others too early, the last one waits for a checkpoint.
      if (killed + 1 == kills && resumed == 0)
        wait_for(checkpoint);
      else
        sleep_seconds(moment(random));
      child.send(SIGKILL);
    }
    const ChildEnded ended = child.wait();
    if (ended.signal == SIGKILL) {
      ++killed;
      CHECK_FALSE(has_left_openmp(child.process(), begin));
      continue;
    }
    CAPTURE(ended.err);
    REQUIRE(ended.status == 0);
    const RunLeft left = left_in(results);
    CHECK(left.rows == expected.rows);
    CHECK(left.summary == expected.summary);
    fs::remove_all(results);
  }
  CHECK(resumed > 0);
}
