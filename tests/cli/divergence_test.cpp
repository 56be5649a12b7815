#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"

using nlohmann::json;

TEST_CASE("one linear body per blade diverges with a diagnosis and keeps its results") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"run", shipped("paper_rotor"), "--set", "blade.bodies=1"}, folder);
  CHECK(ended.status == 3);
  REQUIRE(lines_of(ended.err).size() == 1);
  const std::string message = lines_of(ended.err)[0];
  for (const char* part : {"t = 1", "blade 1", "body 1", "geometric_stiffening"}) {
    CAPTURE(part);
    CHECK(message.find(part) != std::string::npos);
  }
  const auto results = folder.path() / "results" / "paper_rotor";
  const json summary = json::parse(read_file(results / "summary.json"));
  CHECK(summary["status"] == "diverged");
  CHECK(summary["message"] == message);
  CHECK(summary["sensors"]["blade1.tip.y"]["min"].get<double>() < -1.0);
  const auto rows = lines_of(read_file(results / "sensors.csv"));
  REQUIRE(rows.size() > 200);
  const double last = std::stod(rows.back());
  CHECK(last > 9.0);
  CHECK(last < 11.5);
  CHECK(last ==
        doctest::Approx(summary["step_size_s"].get<double>() * (summary["steps"].get<double>()))
            .epsilon(1e-3));
  const std::string page = read_file(results / "report.html");
  CHECK(page.find("class=\"note bad\"") != std::string::npos);
  CHECK(page.find("The page shows what came before") != std::string::npos);
  CHECK(page.find("film-play") != std::string::npos);
}

TEST_CASE("rk4 beyond its stable step diverges with status 3") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"run", shipped("wu_haug_rotor"), "--integrator", "rk4", "--quiet", "--out", "o"}, folder);
  CHECK(ended.status == 3);
  CHECK(ended.out.empty());
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(ended.err.find("rk4") != std::string::npos);
  CHECK(json::parse(read_file(folder.path() / "o" / "summary.json"))["status"] == "diverged");
  CHECK(lines_of(read_file(folder.path() / "o" / "sensors.csv")).size() >= 2);
  const std::string page = read_file(folder.path() / "o" / "report.html");
  CHECK(page.find("The run was too short for an animation.") != std::string::npos);
}
