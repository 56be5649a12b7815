#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/program/cli/refusal.h"
#include "tests/program/cli/study_folder.h"

namespace {

const std::string kLoadCases =
    "scenario = \"rotor.toml\"\n[load_cases]\nstandard = \"IEC 61400-1\"\nclasses = [\"IIB\"]\n"
    "cut_in = 3\nrated = 11\ncut_out = 25\ncases = [\"1.1\", \"1.4\", \"1.5\", \"6.1\"]\n"
    "seeds = 2\n";

std::vector<std::string> cells_of_line(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

std::vector<std::string> list_study(const StudyFolder& folder) {
  const Ended ended = run_spoke({"study", "study.toml", "--list"}, folder.work());
  CHECK(ended.err.empty());
  REQUIRE(ended.status == 0);
  return lines_of(ended.out);
}

}  // namespace

TEST_CASE("load cases are a table, whose hours are Weibull's between cut-in and cut-out") {
  const StudyFolder folder;
  folder.write_study(kLoadCases +
                     "[[load_cases.override]]\ncases = [\"6.1\"]\n"
                     "set = [\"hub.drive.speed=0\", \"wind.iec.turbulent=true\"]\n");
  const std::vector<std::string> lines = list_study(folder);
  // 12 speeds of 2 seeds; 3 speeds of 2 signs; 12 speeds of 2 signs and 2 directions; one.
  REQUIRE(lines.size() == 1 + 24 + 6 + 48 + 1);
  CHECK(lines[0] ==
        "load_case,partial_factor,hours,wind.iec.class,wind.iec.case,wind.iec.speed,wind.iec.seed,"
        "wind.iec.start,wind.iec.sign,wind.iec.direction,wind.iec.period,integration.duration,"
        "hub.drive.speed,wind.iec.turbulent");
  CHECK(lines[79] == "DLC 6.1,1.35,,IIB,EWM,,,,,,50,90,0,true");
  CHECK(lines[25] == "DLC 1.4,1.35,,IIB,ECD,9,,30,1,,,90,,");
  double hours = 0.0;
  for (std::size_t k = 1; k <= 24; ++k) {
    const std::vector<std::string> cells = cells_of_line(lines[k]);
    CHECK(cells.at(6) == std::to_string(k));  // each seed once
    hours += std::stod(cells.at(2));
  }
  // Rayleigh's distribution of mean 8.5 m/s.
  const auto beyond = [](double speed) {
    return std::exp(-std::numbers::pi / 4.0 * std::pow(speed / 8.5, 2));
  };
  CHECK(hours == doctest::Approx(20.0 * 8766.0 * (beyond(3.0) - beyond(25.0))).epsilon(1e-9));
}

TEST_CASE("statistics are the same on all threads and of the listed table, and are the responses") {
  const StudyFolder folder;
  const std::string statistics = "\n[statistics]\nexponents = [3]\n";
  folder.write_study(kSmallStudy + statistics);
  const Left one = folder.run({"--out", "one", "--threads", "1"});
  CHECK(one == folder.run({"--out", "three", "--threads", "3"}));
  const std::vector<std::string> listed = list_study(folder);
  REQUIRE(listed.size() == 13);
  std::string table;
  for (const std::string& line : listed) table += line + '\n';
  folder.work().write("t.csv", table);
  folder.write_study("scenario = \"rotor.toml\"\ndesign = { kind = \"table\", file = \"t.csv\" }" +
                     statistics);
  const Left again = folder.run({"--out", "again"});
  CHECK(again.at("statistics.csv") == one.at("statistics.csv"));
  CHECK(again.at("extremes.csv") == one.at("extremes.csv"));
  CHECK(one.at("study.html").find("Extremes, with partial factors") != std::string::npos);
  // The least of all runs is in the row of its run.
  double least = 0.0;
  std::string run;
  for (const std::string& row : lines_of(one.at("runs.csv"))) {
    const std::vector<std::string> cells = cells_of_line(row);
    if (cells[0] == "run" || std::stod(cells.at(5)) >= least) continue;
    least = std::stod(cells.at(5));
    run = cells[0];
  }
  bool is_found = false;
  for (const std::string& row : lines_of(one.at("extremes.csv")))
    if (row.starts_with("blade1.tip.y,m,min,")) {
      const std::vector<std::string> cells = cells_of_line(row);
      CHECK(cells.at(3) == run);
      CHECK(std::stod(cells.at(6)) == least);
      is_found = true;
    }
  CHECK(is_found);
}

TEST_CASE("of several classes each has all cases, and its share of the lifetime") {
  const auto hours_of = [](const std::string& classes, const std::string& load_case) {
    const StudyFolder folder;
    std::string text = kLoadCases;
    folder.write_study(text.replace(text.find("[\"IIB\"]"), 7, classes));
    double hours = 0.0;
    int rows = 0;
    for (const std::string& line : list_study(folder)) {
      const std::vector<std::string> cells = cells_of_line(line);
      if (cells.at(0) != load_case) continue;
      hours += std::stod(cells.at(2));
      ++rows;
    }
    CHECK(rows == 24);
    return hours;
  };
  CHECK(hours_of("[\"IIB\", \"IC\"]", "DLC 1.1 IIB") ==
        doctest::Approx(0.5 * hours_of("[\"IIB\"]", "DLC 1.1")).epsilon(1e-8));
  CHECK(hours_of("[\"IIB\", \"IC\"]", "DLC 1.1 IC") ==
        doctest::Approx(0.5 * hours_of("[\"IC\"]", "DLC 1.1")).epsilon(1e-8));
}

TEST_CASE("an empty cell of a table leaves the scenario's own value") {
  const StudyFolder folder;
  folder.work().write("t.csv", "blade.length,blade.bodies\n,2\n3,\n");
  folder.write_study(
      "scenario = \"rotor.toml\"\ndesign = { kind = \"table\", file = \"t.csv\" }\n"
      "[[response]]\nsensor = \"blade1.tip.y\"\nkind = \"min\"\n");
  const std::vector<std::string> rows = lines_of(folder.run({"--out", "o"}).at("runs.csv"));
  CHECK(rows.at(1).starts_with("1,done,,2,-"));
  CHECK(rows.at(2).starts_with("2,done,3,,-"));
}

TEST_CASE("wrong load cases and statistics are refused with place, key and value") {
  const StudyFolder folder;
  const auto refused = [&](const std::string& study, const std::string& message) {
    folder.write_study(study);
    check_refused({"study", "study.toml", "--out", "o"}, message, folder.work());
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = kLoadCases;
    return text.replace(text.find(from), from.size(), to);
  };
  refused(with("IEC 61400-1", "GL"), "load_cases.standard: is \"GL\", expected \"IEC 61400-1\"");
  refused(with("IIB", "IV"), "load_cases.classes.1: is \"IV\", expected \"IA\"");
  refused(with("[\"IIB\"]", "[]"), "load_cases.classes: is an empty array");
  refused(with("[\"IIB\"]", "[\"IIB\", \"IIB\"]"),
          "load_cases.classes.2: is \"IIB\" a second time");
  refused(with("rated = 11", "rated = 2"), "load_cases.rated: is 2, expected a speed above");
  refused(with("cut_out = 25", "cut_out = 5"), "load_cases.cut_out: is 5, expected a speed above");
  refused(with("\"6.1\"", "\"9.1\""), "load_cases.cases.4: is \"9.1\", expected \"1.1\"");
  refused(with("\"6.1\"", "\"1.1\""), "load_cases.cases.4: is \"1.1\" a second time");
  refused(kLoadCases + "speeds = [2, 5]\n", "load_cases.speeds.1: is 2, expected a speed from");
  refused("design = { kind = \"grid\" }\n" + kLoadCases,
          "design: stands beside load_cases, which are a design");
  const std::string override_head = "[[load_cases.override]]\ncases = ";
  refused(kLoadCases + override_head + "[\"6.1\"]\nset = [\"speed\"]\n",
          "set.1: is \"speed\", expected a text \"KEY=VALUE\"");
  refused(kLoadCases + override_head + "[\"6.1\"]\nset = [\"hub.axis=[1, 0]\"]\n",
          "set.1: sets an array or a table");
  refused(kLoadCases + override_head + "[\"6.2\"]\nset = [\"a=1\"]\n",
          "has \"6.2\", which is none of the study's");
  const auto with_statistics = [](const std::string& keys) {
    return kSmallStudy + ("\n[statistics]\n" + keys);
  };
  refused(with_statistics("sensors = [\"tower.*\"]\n"), "\"tower.*\" is no sensor, expected one");
  refused(with_statistics("sensors = [3]\n"), "statistics.sensors.1: is 3, expected a text");
  refused(with_statistics("exponents = [0.5]\n"), "statistics.exponents.1: is 0.5, expected");
  refused(with_statistics("from = 1.0\n"), "statistics begin at 1 s, expected a time before the");
  folder.work().write("t.csv", "blade.length,partial_factor\n2,0\n");
  refused(
      "scenario = \"rotor.toml\"\ndesign = { kind = \"table\", file = \"t.csv\" }\n"
      "[statistics]\n",
      "partial_factor: is 0 in run 1, expected a number above 0");
}

TEST_CASE("load cases replace the turbulence and the gusts of the scenario") {
  const std::string rotor = R"(
world = "space"
[hub.drive]
kind = "constant"
speed = 2.0
[air]
density = 1.225
[wind]
velocity = [8.0, 0.0, 0.0]
up = [0.0, 0.0, 1.0]
reference_height = 30.0
gust = { amplitude = 3.0, start = 1.0, duration = 2.0 }
[wind.turbulence]
intensity = 0.4
width = 30.0
[blade]
count = 2
length = 10.0
bodies = 1
elements = 1
[blade.sections]
mass_per_length = 20.0
axial_stiffness = 1e8
flap_stiffness = 1e6
lag_stiffness = 1e6
torsion_stiffness = 1e5
flap_inertia = 1.0
lag_inertia = 1.0
[support]
from = "ground"
[[support.body]]
name = "tower"
kind = "rigid"
mass = 100.0
inertia = 100.0
drag = { area = [1.0, 1.0, 1.0] }
[[support.joint]]
child = "tower"
kind = "fixed"
offset = [0.0, 0.0, 30.0]
[support.axle]
body = "tower"
orientation = [0.0, 1.5707963267948966, 0.0]
[[sensor]]
name = "wind"
quantity = "wind"
subsystem = "support"
body = "hub"
[integration]
step = 0.01
duration = 1.0
)";
  const StudyFolder folder;
  folder.work().write("rotor.toml", rotor);
  folder.write_study(
      "scenario = \"rotor.toml\"\n[load_cases]\nstandard = \"IEC 61400-1\"\n"
      "classes = [\"IIB\"]\ncut_in = 3\nrated = 11\ncut_out = 25\nspeeds = [8]\n"
      "cases = [\"1.1\", \"4.1\"]\nseeds = 1\nduration = 1\nsettle = 0\ngust_duration = 3\n"
      "[[load_cases.override]]\ncases = [\"1.1\"]\nset = [\"wind.turbulence.points=5\", "
      "\"wind.turbulence.scale=none\"]\n[statistics]\nsensors = [\"support.wind.*\"]\n");
  const Left left = folder.run({"--out", "out"});
  // Of cases without turbulence and gusts the wind is the same at all times.
  const std::vector<std::string> speeds = {"", "3", "11", "25"};
  std::size_t runs = 0;
  for (const std::string& row : lines_of(left.at("statistics.csv"))) {
    const std::vector<std::string> cells = cells_of_line(row);
    if (cells.at(1) != "support.wind.x") continue;
    CHECK((cells.at(4) == "0") == (runs > 0));
    if (runs > 0) CHECK(cells.at(5) == speeds.at(runs));
    ++runs;
  }
  CHECK(runs == speeds.size());
}
