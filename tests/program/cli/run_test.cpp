#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/approx.h"
#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

namespace fs = std::filesystem;
using nlohmann::json;
using spoke::testing::approx;

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

json summary_in(const fs::path& folder) { return json::parse(file_text(folder / "summary.json")); }

}  // namespace

TEST_CASE("run prints what it does and writes rows and a summary to a folder of its name") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"run", shipped("wu_haug_rotor"), "--set", "integration.duration=1", "--threads", "2"},
      folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part : {"Wu & Haug 1988 rotor", "144 coordinates", " nodes, ",
                           "structured, generalized_alpha, 200 steps of 0.005 s, auto on 2 "
                           "threads",
                           "m at 1 s (blades 1-3)", "residual",
                           "results/wu_haug_rotor/sensors.csv, summary.json, report.html"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  CHECK(ended.out.find('\r') == std::string::npos);

  const fs::path results = folder.path() / "results" / "wu_haug_rotor";
  const auto rows = lines_of(file_text(results / "sensors.csv"));
  REQUIRE(rows.size() == 22);
  const auto header = cells_of(rows[0]);
  CHECK(header[0] == "t");
  CHECK(header[1] == "blade1.tip.x");
  CHECK(header[2] == "blade1.tip.y");
  CHECK(cells_of(rows[1])[0] == "0");
  CHECK(std::stod(cells_of(rows[2])[0]) == approx(0.05));
  CHECK(std::stod(cells_of(rows[21])[0]) == approx(1.0));
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

  const auto rows = lines_of(file_text(folder.path() / "a" / "b" / "sensors.csv"));
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

TEST_CASE("statistics are those of the rows from their time on") {
  const WorkFolder folder;
  const std::vector<std::string> arguments = {"run",        shipped("wu_haug_rotor"),
                                              "--set",      "integration.duration=0.5",
                                              "--set",      "blade.bodies=2",
                                              "--out",      "o",
                                              "--quiet",    "--no-report",
                                              "--executor", "serial"};
  REQUIRE(run_spoke(arguments, folder).status == 0);
  CHECK_FALSE(summary_in(folder.path() / "o").contains("statistics"));
  std::vector<std::string> asked = arguments;
  asked.insert(asked.end(), {"--statistics-from", "0.2"});
  REQUIRE(run_spoke(asked, folder).status == 0);
  const json statistics = summary_in(folder.path() / "o")["statistics"];
  const auto rows = lines_of(file_text(folder.path() / "o" / "sensors.csv"));
  const auto header = cells_of(rows[0]);
  const auto column = static_cast<std::size_t>(
      std::find(header.begin(), header.end(), "blade2.root.moment") - header.begin());
  REQUIRE(column < header.size());
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const auto cells = cells_of(rows[k]);
    if (std::stod(cells[0]) < 0.199) continue;
    sum += std::stod(cells[column]);
    ++count;
  }
  CHECK(statistics["rows"] == count);
  const json& moment = statistics["sensors"]["blade2.root.moment"];
  CHECK(moment["mean"].get<double>() == approx(sum / count));
  CHECK(moment["damage_equivalent_range"].get<double>() > 0.0);
  for (const char* seconds : {"-1", "nan", "inf", "soon"}) {
    const Ended ended =
        run_spoke({"run", shipped("wu_haug_rotor"), "--statistics-from", seconds}, folder);
    CHECK(ended.status == 2);
    CHECK(ended.err.find("--statistics-from: expected a number of 0 or more [s]") !=
          std::string::npos);
  }
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
    CHECK(final_tip(options) == approx(expected).epsilon(1e-4));
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

TEST_CASE("scenarios with odd names have results in a folder of their own") {
  const std::vector<std::pair<std::string, std::string>> names{{"...toml", "scenario"},
                                                               {"-x.toml", "-x"},
                                                               {"--y.toml", "--y"},
                                                               {" .toml", " "},
                                                               {"a b;c.toml", "a b;c"}};
  for (const auto& names_of_one : names) {
    const std::string &file = names_of_one.first, &name = names_of_one.second;
    CAPTURE(file);
    const WorkFolder folder;
    folder.write(file, file_text(shipped("wu_haug_rotor")));
    const Ended ended = run_spoke(
        {"run", file, "--quiet", "--set", "integration.duration=0.05", "--no-report"}, folder);
    CHECK(ended.status == 0);
    CHECK(ended.err.empty());
    CHECK(fs::exists(folder.path() / "results" / name / "sensors.csv"));
    CHECK(folder.entries() == 5);
  }
}

TEST_CASE("a second run replaces the results of the first") {
  const WorkFolder folder;
  for (const char* duration : {"integration.duration=0.2", "integration.duration=0.1"}) {
    REQUIRE(run_spoke({"run", shipped("simo_vu_quoc_beam"), "--set", duration, "--quiet"}, folder)
                .status == 0);
  }
  const fs::path results = folder.path() / "results" / "simo_vu_quoc_beam";
  CHECK(lines_of(file_text(results / "sensors.csv")).size() == 4);
  CHECK(summary_in(results)["steps"] == 20);
  CHECK(folder.entries() == 5);  // two folders, three files
}

TEST_CASE("run writes a page that needs nothing from elsewhere, unless told not to") {
  const WorkFolder folder;
  const std::vector<std::string> arguments = {"run", shipped("wu_haug_rotor"), "--set",
                                              "integration.duration=0.5", "--quiet"};
  REQUIRE(run_spoke(arguments, folder).status == 0);
  const fs::path results = folder.path() / "results" / "wu_haug_rotor";
  const std::string page = file_text(results / "report.html");
  for (const char* part : {"Wu &amp; Haug 1988 rotor", "0.5 s in 100 steps of 0.005 s",
                           "beam elements</dt><dd>48<", "61 nodes, 78 edges", "generalized_alpha",
                           "energy.residual", "id=\"run-data\"", "class TimePlot"}) {
    CAPTURE(part);
    CHECK(page.find(part) != std::string::npos);
  }
  for (const char* part : {"http:", "https:", "src=", "<link", "@import", "import "}) {
    CAPTURE(part);
    CHECK(page.find(part) == std::string::npos);
  }
  const json summary = summary_in(results);
  CHECK(page.find(summary["state_hash"].get<std::string>()) != std::string::npos);

  std::vector<std::string> without = arguments;
  without.emplace_back("--no-report");
  REQUIRE(run_spoke(without, folder).status == 0);
  CHECK_FALSE(fs::exists(results / "report.html"));
  CHECK(summary_in(results)["state_hash"] == summary["state_hash"]);
}

TEST_CASE("--vtk writes the blades at every output time and an index of them") {
  const WorkFolder folder;
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {
        "run",   shipped("wu_haug_rotor"),   "--quiet", "--out", "o",
        "--set", "integration.duration=0.47"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_spoke(arguments, folder).status;
  };
  REQUIRE(run({"--vtk"}) == 0);
  const fs::path vtk = folder.path() / "o" / "vtk";
  const std::string index = file_text(vtk / "blades.pvd");
  const auto rows = lines_of(file_text(folder.path() / "o" / "sensors.csv"));
  REQUIRE(rows.size() == 12);  // header, 0 to 0.45 s, and the end
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    const std::string name = "blades_0000" + std::string(k < 10 ? "0" : "") + std::to_string(k);
    CHECK(fs::exists(vtk / (name + ".vtp")));
    CHECK(index.find("timestep=\"" + cells_of(rows[k + 1])[0] + "\" part=\"0\" file=\"" + name) !=
          std::string::npos);
  }
  const std::string first = file_text(vtk / "blades_000000.vtp");
  CHECK(first.find("NumberOfPoints=\"51\" NumberOfLines=\"48\"") != std::string::npos);
  const std::string hash = summary_in(folder.path() / "o")["state_hash"];

  // Files of an earlier run go, others stay.
  folder.write("o/vtk/notes.txt", "mine");
  REQUIRE(run({}) == 0);
  CHECK(fs::exists(vtk / "notes.txt"));
  CHECK_FALSE(fs::exists(vtk / "blades.pvd"));
  CHECK_FALSE(fs::exists(vtk / "blades_000000.vtp"));
  CHECK(summary_in(folder.path() / "o")["state_hash"] == hash);
}

TEST_CASE("a file in place of the folder of --vtk is refused") {
  const WorkFolder folder;
  fs::create_directories(folder.path() / "o");
  folder.write("o/vtk", "no folder");
  const Ended ended =
      run_spoke({"run", shipped("wu_haug_rotor"), "--vtk", "--quiet", "--out", "o"}, folder);
  CHECK(ended.status == 2);
  REQUIRE(lines_of(ended.err).size() == 1);
  CHECK(ended.err.find("o/vtk: cannot be the folder of results") != std::string::npos);
  CHECK(file_text(folder.path() / "o" / "vtk") == "no folder");
  CHECK(folder.entries() == 2);
}

TEST_CASE("a run that is refused for its folder leaves the results of an earlier one as they are") {
  const WorkFolder folder;
  const std::vector<std::string> run = {"run",   shipped("wu_haug_rotor"),  "--quiet", "--out", "o",
                                        "--set", "integration.duration=0.1"};
  REQUIRE(run_spoke(run, folder).status == 0);
  const fs::path results = folder.path() / "o";
  const std::string rows = file_text(results / "sensors.csv");
  const auto refused = [&](const std::vector<std::string>& more, const std::string& message) {
    std::vector<std::string> arguments = run;
    arguments.insert(arguments.end(), more.begin(), more.end());
    check_refused(arguments, message, folder);
    CHECK(file_text(results / "sensors.csv") == rows);
    CHECK(fs::exists(results / "report.html"));
  };
  folder.write("o/vtk", "no folder");
  refused({"--vtk"}, "o/vtk: cannot be the folder of results: ");
  refused({"--trace", "o/vtk"}, "o/vtk: cannot be the folder of results: ");
  fs::remove(results / "vtk");
  fs::create_symlink("nowhere", results / "vtk");
  refused({"--vtk"}, "o/vtk: cannot be the folder of results: ");
  fs::create_directories(results / "checkpoint.spoke" / "inside");
  refused({}, "o/checkpoint.spoke: cannot be written: Is a directory");
}
