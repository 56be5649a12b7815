#include "program/run_report/html_file.h"

#include <doctest/doctest.h>
#include <spdlog/fmt/fmt.h>

#include <nlohmann/json.hpp>

#include "program/report/markup.h"
#include "program/run_report/row_statistics.h"
#include "tests/approx.h"
#include "tests/engine/bodies/space/system/models.h"
#include "tests/program/run_report/scenarios.h"

using namespace spoke;
using namespace spoke::run_report;
using namespace spoke::test;
using nlohmann::json;
using spoke::testing::approx;

namespace {

/// A run of `scenario`, recorded at all its steps.
struct Run {
  explicit Run(const Scenario& scenario)
      : simulation(scenario, test_options()),
        statistics(simulation.sensor_names().size()),
        rows(simulation),
        recorder(simulation) {
    add();
    for (int k = 0; k < 20; ++k) {
      simulation.run_until(0.1 * (k + 1));
      add();
    }
  }
  void add() {
    statistics.add(simulation.time(), simulation.sensor_values());
    rows.add_row(simulation.time(), simulation.sensor_values());
    recorder.add_row(simulation.time(), simulation.sensor_values());
    recorder.add_picture(simulation);
  }
  std::string page(const TipSummary& tips = {}) const {
    return make_html(simulation, statistics, {0.5, ""}, tips, recorder, rows);
  }

  Simulation simulation;
  SensorStatistics statistics;
  RunStatistics rows;
  Recorder recorder;
};

double largest_lag(const Run& run) {
  return run.statistics.ranges()[run.simulation.sensor_index("blade2.tip.across")].min;
}

}  // namespace

TEST_CASE("the data hold the curves of all plots and an animation") {
  const Run run(test_scenario());
  const json data = json::parse(make_data(run.recorder, {}));
  CHECK(data["end"] == approx(2.0));
  REQUIRE(data["plots"].size() == 8);
  CHECK(data["plots"][0]["title"] == "Tip deflection across the blade");
  CHECK(data["plots"][0]["curves"].size() == 2);
  // 21 samples of a time and a value, 4 bytes each, in base64
  CHECK(data["plots"][0]["curves"][0]["samples"].get<std::string>().size() == 224);
  CHECK(data["scene"]["trees"] == json::array({"blade 1", "blade 2"}));
  CHECK(data["scene"]["strips"].size() == 4);
  // 21 frames of an angle of 16 nodes, 2 bytes each, in base64
  CHECK(data["animation"]["rotations"].get<std::string>().size() == 896);
}

TEST_CASE("the data hold the events that have acted, in order of time") {
  const Run run(test_scenario());
  CHECK(!json::parse(make_data(run.recorder, {{"never", std::nullopt}})).contains("events"));
  const json data = json::parse(
      make_data(run.recorder, {{"late", 1.5}, {"never", std::nullopt}, {"early <1>", 0.25}}));
  CHECK(data["events"] ==
        json::parse(R"([{"name": "early <1>", "t": 0.25}, {"name": "late", "t": 1.5}])"));
}

TEST_CASE("a page without a moving picture does not speak of one") {
  const Simulation simulation(test_scenario(), test_options());
  SensorStatistics statistics(simulation.sensor_names().size());
  statistics.add(0.0, simulation.sensor_values());
  Recorder recorder(simulation);
  recorder.add_row(0.0, simulation.sensor_values());
  const std::string still =
      make_html(simulation, statistics, {0.5, ""}, {}, recorder, RunStatistics(simulation));
  CHECK(still.find("Drag to zoom, double-click to reset. With the keyboard") != std::string::npos);
  CHECK(still.find("animation there") == std::string::npos);
  const Run run(test_scenario());
  const std::string moving = run.page();
  CHECK(moving.find("click to move the animation there") != std::string::npos);
}

TEST_CASE("a run in space has a moving picture, and its largest tip displacement first") {
  Scenario scenario = parse_scenario(make_text(kFlyingHub, kTree), "test");
  scenario.integration.duration = 2.0;
  const Run run(scenario);
  const json data = json::parse(make_data(run.recorder, {}));
  CHECK(data["scene"]["isPlanar"] == false);
  CHECK(data["scene"]["joints"].size() == 5);
  const std::string html = run.page({0.125, "at 1 s (arm)"});
  CHECK(html.find("Largest tip displacement") != std::string::npos);
  CHECK(html.find("at 1 s (arm)") != std::string::npos);
  CHECK(html.find("id=\"animation-inertial\"") != std::string::npos);
}

TEST_CASE("deflections across and along the blade have the blade's directions") {
  const Run run(test_scenario());
  const auto across = run.recorder.curves().curve(1).back();
  const auto along = run.recorder.curves().curve(3).back();
  CHECK(across.value == approx(-run.simulation.sensor("blade2.tip.y")));
  CHECK(along.value == approx(-run.simulation.sensor("blade2.tip.x")));
  CHECK(across.value < 0.0);  // lags behind
}

TEST_CASE("the page has the model's numbers, settings and extremes, and escapes the title") {
  const Run run(test_scenario());
  const std::string html = run.page({largest_lag(run), "at 1 s (blades 1-2)"});
  for (const char* part :
       {"two &lt;/script&gt; blades", "2 s in 200 steps of 0.01 s", "at 1 s (blades 1-2)",
        "beam elements</dt><dd>12<", "structured", "blade2.tip.y",
        "The plots show every row of sensors.csv.", "The animation has 21 pictures"}) {
    CAPTURE(part);
    CHECK(html.find(part) != std::string::npos);
  }
  // Both blades lag alike, by some millimetres.
  const std::string tile = "<strong>" + report::quantity(largest_lag(run), "m", 5) + "</strong>";
  CAPTURE(tile);
  CHECK(tile.ends_with(" mm</strong>"));
  CHECK(html.find(tile) != std::string::npos);
  CHECK(html.find("note bad") == std::string::npos);
  CHECK(html.find("note warning\">\n") == std::string::npos);
}

TEST_CASE("a failure is told at the top, and advice is that of the warnings alone") {
  const Run run(test_scenario());
  SensorStatistics statistics(run.simulation.sensor_names().size());
  std::vector<double> values(run.simulation.sensor_names().size(), 1.0);
  statistics.add(2.0, values);  // residual as large as the kinetic energy
  const std::string html =
      make_html(run.simulation, statistics, {0.5, "blade 1 <left>"}, {}, run.recorder, run.rows);
  CHECK(html.find("<div class=\"note bad\">\n<p>blade 1 &lt;left&gt;</p>") != std::string::npos);
  CHECK(run.simulation.warnings().empty());
  CHECK(html.find("<div class=\"note warning\">") == std::string::npos);
}

TEST_CASE("a run in air has the statistics of its rows, other runs have none") {
  Scenario scenario = parse_scenario(make_text(kDrivenHub, kBooms + kAir), "test");
  scenario.integration.duration = 2.0;
  const Run run(scenario);
  const std::string html = run.page();
  CHECK(html.find("Over 21 rows of sensors.csv from 0 to 2 s.") != std::string::npos);
  CHECK(html.find("damage in that time, by rainflow counting and exponent 10") !=
        std::string::npos);
  const auto find = [&](const std::string& name) {
    for (const SensorSeries& series : run.rows.series())
      if (run.simulation.sensor_names()[series.sensor] == name) return series;
    FAIL("no series ", name);
    return SensorSeries{};
  };
  const auto row = [&](const std::string& name) {
    std::string cells;
    for (const report::Row& each : make_statistics_table(run.simulation, run.rows).rows)
      if (each.cells[0] == name)
        for (const std::string& cell : each.cells) cells += cell + '|';
    return cells;
  };
  const SeriesStatistics power = find("air.power").values;
  CHECK(row("air.power") == fmt::format("air.power|W|{:.6g}|{:.6g}|{:.6g}|{:.6g}|||", power.mean(),
                                        power.deviation(), power.min(), power.max()));
  const double range = run.rows.equivalent_range(find("blade2.root.moment.y"));
  CHECK(range > 0.0);
  CHECK(row("blade2.root.moment.y").ends_with(fmt::format("|{:.6g}|10|", range)));
  CHECK(html.find("<strong>" + report::quantity(power.mean(), "W", 4)) != std::string::npos);

  const std::string without = Run(test_scenario()).page();
  CHECK(without.find("Statistics") == std::string::npos);
  CHECK(without.find("Mean power") == std::string::npos);
}
