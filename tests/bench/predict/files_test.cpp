#include "bench/predict/files.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "bench/predict/table.h"
#include "tests/approx.h"
#include "tests/bench/predict/samples.h"

using namespace spoke;
using namespace spoke::predict;
using spoke::testing::approx;

namespace {

/// serial and auto were measured.
Prediction sample() {
  Prediction prediction = sample_prediction();
  prediction.rounds = 15;
  prediction.series = {series_of(ExecutorKind::flow_graph, {{1, 12e-6}, {2, 8e-6}}),
                       series_of(ExecutorKind::automatic, {{1, 10e-6}, {2, 5e-6}}, 50)};
  measure_as(10e-6, 1.0, prediction.serial);
  measure_as(4e-6, 2.5, prediction.series[1].points[1]);
  return prediction;
}

std::string fact(const std::vector<report::Fact>& facts, const std::string& label) {
  for (const auto& [name, text] : facts)
    if (name == label) return text;
  return "";
}

}  // namespace

TEST_CASE("the table has a row per point, with its window") {
  const report::Table table = make_table(sample());
  using Cells = std::vector<std::string>;
  REQUIRE(table.rows.size() == 5);
  for (const report::Row& row : table.rows) CHECK(row.cells.size() == table.columns.size());
  CHECK(table.rows[0].cells ==
        Cells{"serial", "1", "1", "10", "9-11", "1.00", "1", "10", "1.00", "+0.0 %", ""});
  CHECK(table.rows[2].cells ==
        Cells{"flow_graph", "2", "1", "8", "7.2-8.8", "1.25", "3", "", "", "", ""});
  CHECK(table.rows[4].cells ==
        Cells{"auto", "2", "50", "5", "4.5-5.5", "2.00", "3", "4", "2.50", "+25.0 %", ""});
}

TEST_CASE("facts are given of each graph that is run") {
  Prediction prediction = sample();
  CHECK(fact(make_facts(prediction), "graph of a run") == "7 nodes, 0 edges, for runs of one pass");
  CHECK(fact(make_facts(prediction), "graph of auto") ==
        "350 nodes, 0 edges, for windows of 50 steps");
  prediction.auto_run.reset();
  CHECK(fact(make_facts(prediction), "graph of auto").empty());
}

TEST_CASE("predict.csv has a row per point, the window last") {
  std::istringstream lines(make_csv(sample()));
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  REQUIRE(rows.size() == 6);
  for (const std::string& row : rows) CHECK(std::count(row.begin(), row.end(), ',') == 10);
  CHECK(rows[0].starts_with("executor,threads,predicted_s,"));
  CHECK(rows[0].ends_with(",measured_s,measured_speedup,error,window_steps"));
  CHECK(rows[3].starts_with("flow_graph,2,"));
  CHECK(rows[3].ends_with(",3,,,,1"));
  CHECK(rows[5].starts_with("auto,2,"));
  CHECK(rows[5].ends_with(",50"));
}

TEST_CASE("predict.json and predict.html have both graphs") {
  Prediction prediction = sample();
  const auto json = nlohmann::json::parse(make_json(prediction));
  CHECK(json["model"]["window_steps"] == 1);
  CHECK(json["model"]["run_nodes"] == 7);
  CHECK(json["parallelism"].get<double>() == approx(5.0));
  CHECK(json["auto_window"]["window_steps"] == 50);
  CHECK(json["auto_window"]["run_nodes"] == 350);
  CHECK(json["auto_window"]["parallelism"].get<double>() == approx(10.0));
  REQUIRE(json["points"].size() == 5);
  CHECK(json["points"][2]["window_steps"] == 1);
  CHECK(json["points"][2]["measured"].is_null());
  CHECK(json["points"][4]["window_steps"] == 50);
  CHECK(json["points"][4]["measured"]["error"].get<double>() == approx(0.25));
  CHECK(json["not_predicted"].size() == left_out_executors().size());

  const std::string html = make_html(prediction);
  CHECK(html.find("Rotor &lt;1&gt;") != std::string::npos);
  CHECK(html.find("T1 / max(T1/P, Tinf)") != std::string::npos);
  CHECK(html.find("the same, auto") != std::string::npos);

  prediction.auto_run.reset();
  CHECK(nlohmann::json::parse(make_json(prediction))["auto_window"].is_null());
  CHECK(make_html(prediction).find("the same, auto") == std::string::npos);
}

TEST_CASE("one slow point does not flatten the chart of what was measured") {
  const char* const caption = "The axis is logarithmic: compare ends, not lengths.";
  Prediction prediction = sample();
  CHECK(make_html(prediction).find(caption) == std::string::npos);
  measure_as(400e-6, 0.025, prediction.series[0].points[1]);
  CHECK(make_html(prediction).find(caption) != std::string::npos);
  // Nor does a slow quartile.
  prediction = sample();
  measure_as(6e-6, 1.7, prediction.series[0].points[1]);
  CHECK(make_html(prediction).find(caption) == std::string::npos);
  prediction.series[0].points[1].measured->step.high = 400e-6;
  CHECK(make_html(prediction).find(caption) != std::string::npos);
}
