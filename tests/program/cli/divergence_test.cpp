#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/approx.h"
#include "tests/program/cli/program.h"

using nlohmann::json;
using spoke::testing::approx;

namespace {

/// The lines before the last one, which are warnings, without "warning: ".
std::vector<std::string> warnings_before_message(const Ended& ended) {
  std::vector<std::string> lines = lines_of(ended.err);
  REQUIRE(!lines.empty());
  lines.pop_back();
  for (std::string& line : lines) {
    REQUIRE(line.find("warning: ") == 0);
    line.erase(0, 9);
  }
  return lines;
}

}  // namespace

TEST_CASE("one linear body per blade diverges with a diagnosis and keeps its results") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"run", shipped("paper_rotor"), "--set", "blade.bodies=1"}, folder);
  CHECK(ended.status == 3);
  const std::vector<std::string> warnings = warnings_before_message(ended);
  const std::string message = lines_of(ended.err).back();
  for (const char* part : {"t = 1", "blade 1", "body 1", "geometric_stiffening"}) {
    CAPTURE(part);
    CHECK(message.find(part) != std::string::npos);
  }
  const auto results = folder.path() / "results" / "paper_rotor";
  const json summary = json::parse(file_text(results / "summary.json"));
  CHECK(summary["status"] == "diverged");
  CHECK(summary["message"] == message);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].find("blade 1 / body 1 bends by ") == 0);
  CHECK(summary["warnings"] == json(warnings));
  CHECK(summary["sensors"]["blade1.tip.y"]["min"].get<double>() < -1.0);
  const auto rows = lines_of(file_text(results / "sensors.csv"));
  REQUIRE(rows.size() > 200);
  const double last = std::stod(rows.back());
  CHECK(last > 9.0);
  CHECK(last < 11.5);
  CHECK(last == approx(summary["step_size_s"].get<double>() * (summary["steps"].get<double>()))
                    .epsilon(1e-3));
  const std::string page = file_text(results / "report.html");
  CHECK(page.find(warnings[0]) != std::string::npos);
  CHECK(page.find("class=\"note bad\"") != std::string::npos);
  CHECK(page.find("The page shows what came before") != std::string::npos);
  CHECK(page.find("animation-play") != std::string::npos);
}

TEST_CASE("one linear body per blade diverges in space too, and says where") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"run", shipped("spatial_wu_haug"), "--quiet", "--out", "o", "--set",
                 "blade.bodies=1", "--set", "blade.geometric_stiffening=false"},
                folder);
  CHECK(ended.status == 3);
  warnings_before_message(ended);
  const std::string message = lines_of(ended.err).back();
  CAPTURE(message);
  for (const char* part : {"diverged at t = ", "blade 1 / body 1", "of node ", "(limit ",
                           "recovery", "geometric_stiffening"})
    CHECK(message.find(part) != std::string::npos);
  const json summary = json::parse(file_text(folder.path() / "o" / "summary.json"));
  CHECK(summary["status"] == "diverged");
  CHECK(summary["message"] == message);
}

TEST_CASE("rk4 beyond its stable step diverges with status 3") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"run", shipped("wu_haug_rotor"), "--integrator", "rk4", "--quiet", "--out", "o"}, folder);
  CHECK(ended.status == 3);
  CHECK(ended.out.empty());
  warnings_before_message(ended);
  CHECK(lines_of(ended.err).back().find("above the stability limit of rk4") != std::string::npos);
  CHECK(json::parse(file_text(folder.path() / "o" / "summary.json"))["status"] == "diverged");
  CHECK(lines_of(file_text(folder.path() / "o" / "sensors.csv")).size() >= 2);
  const std::string page = file_text(folder.path() / "o" / "report.html");
  CHECK(page.find("The run was too short for an animation.") != std::string::npos);
}

TEST_CASE("a run that bends too far ends well, with one line of warning") {
  const WorkFolder folder;
  std::vector<std::string> run{"run",   shipped("wu_haug_rotor"), "--quiet", "--out", "o",
                               "--set", "limits.deflection=0.01"};
  const Ended ended = run_spoke(run, folder);
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  REQUIRE(lines_of(ended.err).size() == 1);
  CHECK(ended.err.find("warning: blade 1 / body ") == 0);
  const json summary = json::parse(file_text(folder.path() / "o" / "summary.json"));
  CHECK(summary["status"] == "completed");
  REQUIRE(summary["warnings"].size() == 1);
  CHECK("warning: " + summary["warnings"][0].get<std::string>() + "\n" == ended.err);
  run.back() = "limits.deflection=0";
  CHECK(run_spoke(run, folder).err.empty());
  CHECK(json::parse(file_text(folder.path() / "o" / "summary.json"))["warnings"].empty());
}

TEST_CASE("growing energy ends a run with status 3 if the scenario says so") {
  const WorkFolder folder;
  // A little above the stability limit of 8.207e-5 s.
  const Ended ended =
      run_spoke({"run", shipped("wu_haug_rotor"), "--integrator", "rk4", "--quiet", "--out", "o",
                 "--set", "limits.on_energy_growth=stop", "--set", "output.interval=0", "--set",
                 "integration.step=8.6e-5", "--set", "integration.duration=0.2"},
                folder);
  CHECK(ended.status == 3);
  REQUIRE(lines_of(ended.err).size() == 1);
  const std::string message = lines_of(ended.err)[0];
  CHECK(message.find("diverged at t = ") == 0);
  CHECK(message.find("the energy has grown by ") != std::string::npos);
  const json summary = json::parse(file_text(folder.path() / "o" / "summary.json"));
  CHECK(summary["status"] == "diverged");
  CHECK(summary["message"] == message);
  // A header, the start and every step, the one that failed included.
  CHECK(lines_of(file_text(folder.path() / "o" / "sensors.csv")).size() ==
        summary["steps"].get<std::size_t>() + 2);
}
