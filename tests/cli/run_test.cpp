#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

json summary_in(const fs::path& folder) { return json::parse(read_file(folder / "summary.json")); }

}  // namespace

TEST_CASE("run prints what it does and writes rows and a summary to a folder of its name") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"run", shipped("wu_haug_rotor"), "--set", "integration.duration=1", "--threads", "2"},
      folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part :
       {"Wu & Haug 1988 rotor", "144 coordinates", " nodes, ",
        "structured, generalized_alpha, 200 steps of 0.005 s, auto on 2 "
        "threads",
        "m at 1 s (blades 1-3)", "residual", "results/wu_haug_rotor/sensors.csv, summary.json"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  CHECK(ended.out.find('\r') == std::string::npos);

  const fs::path results = folder.path() / "results" / "wu_haug_rotor";
  const auto rows = lines_of(read_file(results / "sensors.csv"));
  REQUIRE(rows.size() == 22);
  const auto header = cells_of(rows[0]);
  CHECK(header[0] == "t");
  CHECK(header[1] == "blade1.tip.x");
  CHECK(header[2] == "blade1.tip.y");
  CHECK(cells_of(rows[1])[0] == "0");
  CHECK(std::stod(cells_of(rows[2])[0]) == doctest::Approx(0.05));
  CHECK(std::stod(cells_of(rows[21])[0]) == doctest::Approx(1.0));
  for (const std::string& row : rows) CHECK(cells_of(row).size() == header.size());
}

TEST_CASE("the summary holds what was run and agrees with the rows") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"run", "--set", "integration.duration=0.5", "output.interval=0",
                                 "blade.bodies=2", shipped("wu_haug_rotor"), "--out", "a/b",
                                 "--quiet", "--executor", "serial", "--formulation", "subsystem"},
                                folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  CHECK(ended.err.empty());
  const json summary = summary_in(folder.path() / "a" / "b");
  CHECK(summary["status"] == "completed");
  CHECK(summary["formulation"] == "subsystem");
  CHECK(summary["integrator"] == "generalized_alpha");
  CHECK(summary["executor"] == "serial");
  CHECK(summary["threads"] == 1);
  CHECK(summary["steps"] == 100);
  CHECK(summary["step_size_s"] == 0.005);
  CHECK(summary["evaluations"].get<int>() >= 100);
  CHECK(summary["wall_time_s"].get<double>() > 0.0);
  CHECK(summary["state_hash"].get<std::string>().size() == 18);
  CHECK(summary["scenario"]["blades"][2]["bodies"] == 2);
  CHECK(summary["scenario"]["integration"]["duration"] == 0.5);
  CHECK(summary["model"]["bodies"] == 6);
  CHECK(summary["machine"]["cores"].get<int>() >= 1);
  CHECK_FALSE(summary["version"].get<std::string>().empty());

  const auto rows = lines_of(read_file(folder.path() / "a" / "b" / "sensors.csv"));
  REQUIRE(rows.size() == 102);
  double lowest = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    lowest = std::min(lowest, std::stod(cells_of(rows[i])[2]));
  }
  const json& tip = summary["sensors"]["blade1.tip.y"];
  CHECK(tip["unit"] == "m");
  CHECK(tip["min"] == lowest);
  CHECK(tip["final"] == std::stod(cells_of(rows.back())[2]));
}

TEST_CASE("every formulation and integrator and executor runs and agrees") {
  const WorkFolder folder;
  const auto final_tip = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"run",    shipped("wu_haug_rotor"),
                                          "--set",  "integration.duration=0.2",
                                          "--set",  "integration.step=5e-5",
                                          "--set",  "blade.count=1",
                                          "--out",  "o",
                                          "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    REQUIRE(run_spoke(arguments, folder).status == 0);
    return summary_in(folder.path() / "o")["sensors"]["blade1.tip.y"]["final"].get<double>();
  };
  const double expected = final_tip({});
  CHECK(expected < 0.0);
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--formulation", "subsystem"},
        {"--formulation", "augmented"},
        {"--integrator", "rk4"},
        {"--executor", "serial"},
        {"--threads", "3"}}) {
    CAPTURE(options[1]);
    CHECK(final_tip(options) == doctest::Approx(expected).epsilon(1e-4));
  }
}

TEST_CASE("--integrator overrides the scenario and the summary says so") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.001", "--set",
                 "integration.step=5e-5", "--integrator", "rk4", "--out", "o", "--quiet"},
                folder);
  CHECK(ended.status == 0);
  const json summary = summary_in(folder.path() / "o");
  CHECK(summary["integrator"] == "rk4");
  CHECK(summary["scenario"]["integration"]["method"] == "rk4");
  CHECK(summary["evaluations"].get<int>() >= 80);
}

TEST_CASE("-v logs to stderr and leaves stdout alone") {
  const WorkFolder folder;
  const std::vector<std::string> arguments = {
      "run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.1", "--quiet", "-v"};
  const Ended ended = run_spoke(arguments, folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  CHECK(ended.err.find("[info]") != std::string::npos);
}

TEST_CASE("a second run replaces the results of the first") {
  const WorkFolder folder;
  for (const char* duration : {"integration.duration=0.2", "integration.duration=0.1"}) {
    REQUIRE(run_spoke({"run", shipped("simo_vu_quoc_beam"), "--set", duration, "--quiet"}, folder)
                .status == 0);
  }
  const fs::path results = folder.path() / "results" / "simo_vu_quoc_beam";
  CHECK(lines_of(read_file(results / "sensors.csv")).size() == 4);
  CHECK(summary_in(results)["steps"] == 20);
  CHECK(folder.entries() == 4);  // two folders, two files
}
