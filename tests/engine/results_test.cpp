#include "engine/results.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/support/machine.h"
#include "tests/approx.h"
#include "tests/file_text.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace fs = std::filesystem;
using namespace spoke;
using spoke::test::file_text;
using spoke::test::message_of;
using spoke::test::TemporaryFolder;
using spoke::testing::approx;

namespace {

/// Returns the steps, of 0 to `count` of size `step`, that are output.
std::vector<int> due_steps(double interval, double step, int count) {
  OutputTimes times(interval);
  std::vector<int> due;
  for (int i = 0; i <= count; ++i) {
    if (times.is_due(i * step)) due.push_back(i);
  }
  return due;
}

constexpr const char* kScenario = R"(
title = "one blade"
[hub.drive]
kind = "spin_up"
speed = 4.0
ramp = 15.0
[blade]
count = 1
length = 8.0
bodies = 1
elements = 2
density = 2766.67
area = 7.299e-5
second_moment = 8.214e-9
youngs_modulus = 6.895e10
[integration]
step = 0.01
duration = 0.1
)";

Simulation make_simulation() {
  SimulationOptions options;
  options.executor = ExecutorKind::serial;
  return Simulation(parse_scenario(kScenario, "one.toml"), options);
}

}  // namespace

TEST_CASE("statistics find extremes and when they were first reached") {
  SensorStatistics statistics(2);
  const std::vector<std::vector<double>> values = {{1.0, 5.0}, {-2.0, 5.0}, {4.0, 6.0}, {4.0, 5.5}};
  for (std::size_t i = 0; i < values.size(); ++i)
    statistics.add(0.5 * static_cast<double>(i), values[i]);
  const SensorRange& first = statistics.ranges()[0];
  CHECK(first.min == -2.0);
  CHECK(first.t_min == 0.5);
  CHECK(first.max == 4.0);
  CHECK(first.t_max == 1.0);
  CHECK(first.final == 4.0);
  const SensorRange& second = statistics.ranges()[1];
  CHECK(second.min == 5.0);
  CHECK(second.t_min == 0.0);
  CHECK(second.max == 6.0);
  CHECK(statistics.last_time() == 1.5);
  CHECK(statistics.final_values() == std::vector<double>{4.0, 5.5});
}

TEST_CASE("values that are not numbers are no extremes") {
  SensorStatistics statistics(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {nan, 2.0, nan}) statistics.add(0.0, std::vector<double>{value});
  CHECK(statistics.ranges()[0].min == 2.0);
  CHECK(statistics.ranges()[0].max == 2.0);
  CHECK(std::isnan(statistics.ranges()[0].final));
}

TEST_CASE("output is due at the first step at or after each multiple of the interval") {
  CHECK(due_steps(0.05, 0.01, 12) == std::vector<int>{0, 5, 10});
  CHECK(due_steps(0.0, 0.01, 3) == std::vector<int>{0, 1, 2, 3});
  CHECK(due_steps(0.025, 0.01, 10) == std::vector<int>{0, 3, 5, 8, 10});
  CHECK(due_steps(0.004, 0.01, 3) == std::vector<int>{0, 1, 2, 3});
  CHECK(due_steps(9.0, 0.01, 3) == std::vector<int>{0});
  CHECK(due_steps(0.1, 0.0001, 200000).size() == 201);
}

TEST_CASE("numbers that mean nothing are refused") {
  for (const double interval : {-1.0, std::nan("")})
    CHECK_THROWS_AS(OutputTimes{interval}, InputError);
  SensorStatistics statistics(3);
  CHECK_THROWS_AS(statistics.add(0.0, std::vector<double>{1.0, 2.0}), InputError);
  CHECK_THROWS_AS(statistics.add(0.0, {}), InputError);
}

TEST_CASE("output times forgive the round-off of summed steps") {
  OutputTimes times(0.05);
  double t = 0.0;
  int rows = 0;
  for (int i = 0; i <= 4000; ++i, t += 0.005) rows += times.is_due(t) ? 1 : 0;
  CHECK(rows == 401);
}

TEST_CASE("rows are written in digits that read back equal") {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "sensors.csv";
  SensorFile file(path, {"a", "b"});
  const std::vector<double> values = {0.1 + 0.2, -1.0 / 3.0};
  file.write_row(0.0, values);
  file.write_row(1e-7, std::vector<double>{1.0, std::numeric_limits<double>::infinity()});
  file.close();
  CHECK(file_text(path) == "t,a,b\n0,0.30000000000000004,-0.3333333333333333\n1e-07,1,inf\n");
}

TEST_CASE("files that cannot be written say why") {
  const TemporaryFolder folder;
  const std::string missing = (folder.path() / "none" / "f").string();
  CHECK(message_of([&] { SensorFile(missing, {}); }) ==
        missing + ": cannot be written: No such file or directory");
  CHECK(message_of([&] { write_file(missing, "text"); }) ==
        missing + ": cannot be written: No such file or directory");
  CHECK(message_of([&] {
          SensorFile full("/dev/full", {"a"});
          full.close();
        }) == "/dev/full: cannot be written: No space left on device");
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("a file is replaced as a whole") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "f";
  write_file(file, "a long first text");
  write_file(file, "second");
  CHECK(file_text(file) == "second");
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("the summary of a run holds what the documentation says") {
  Simulation simulation = make_simulation();
  SensorStatistics statistics(simulation.sensor_names().size());
  statistics.add(simulation.time(), simulation.sensor_values());
  while (!simulation.done()) {
    simulation.step();
    statistics.add(simulation.time(), simulation.sensor_values());
  }
  const auto summary = nlohmann::json::parse(
      make_summary(simulation, statistics, {.wall_time = 0.25, .divergence = ""}));
  CHECK(summary["version"] == SPOKE_VERSION);
  CHECK(summary["status"] == "completed");
  CHECK_FALSE(summary.contains("message"));
  CHECK(summary["scenario"]["title"] == "one blade");
  CHECK(summary["scenario"]["blades"].size() == 1);
  CHECK(summary["model"]["bodies"] == 1);
  CHECK(summary["model"]["coordinates"] == 6);
  CHECK(summary["formulation"] == "structured");
  CHECK(summary["integrator"] == "generalized_alpha");
  CHECK(summary["executor"] == "serial");
  CHECK(summary["executor_choice"] == "serial on 1 thread");
  CHECK(summary["threads"] == 1);
  CHECK(summary["step_size_s"].get<double>() == approx(0.01));
  CHECK(summary["steps"] == 10);
  CHECK(summary["evaluations"] == simulation.evaluations());
  CHECK(summary["wall_time_s"] == 0.25);
  const std::string hash = summary["state_hash"];
  CHECK(hash.size() == 18);
  CHECK(std::stoull(hash, nullptr, 16) == simulation.state_hash());
  CHECK(summary["sensors"].size() == simulation.sensor_names().size());
  const auto& speed = summary["sensors"]["hub.speed"];
  CHECK(speed["unit"] == "rad/s");
  CHECK(speed["final"] == simulation.sensor("hub.speed"));
  CHECK(speed["max"] == speed["final"]);
  CHECK(speed["t_max"].get<double>() == approx(0.1));
  CHECK(speed["min"] == 0.0);
  CHECK(speed["t_min"] == 0.0);
}

TEST_CASE("the summary of a diverged run says so") {
  const Simulation simulation = make_simulation();
  SensorStatistics statistics(simulation.sensor_names().size());
  std::vector<double> values(simulation.sensor_names().size(), 0.0);
  values[0] = std::numeric_limits<double>::infinity();
  statistics.add(0.0, values);
  const auto summary = nlohmann::json::parse(
      make_summary(simulation, statistics, {.wall_time = 1.0, .divergence = "left at t = 1 s"}));
  CHECK(summary["status"] == "diverged");
  CHECK(summary["message"] == "left at t = 1 s");
  CHECK(summary["sensors"]["blade1.tip.x"]["final"].is_null());
}

TEST_CASE("the machine is described") {
  const Machine machine = this_machine();
  CHECK(machine.cores >= 1);
  CHECK(machine.memory > 0);
  CHECK_FALSE(machine.os.empty());
  CHECK_FALSE(machine.compiler.empty());
}
