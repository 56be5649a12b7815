#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/cli/program.h"
#include "tests/program/cli/refusal.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

void check_points(const json& all) {
  for (const json& point : all["points"]) {
    CAPTURE(point.dump());
    const double predicted = point["predicted_s"].get<double>();
    CHECK(point["optimistic_s"].get<double>() <= predicted);
    CHECK(predicted <= point["pessimistic_s"].get<double>());
    // No executor beats work and span.
    CHECK(predicted * point["threads"].get<int>() >= 0.999 * all["work_s"].get<double>());
    CHECK(predicted >= 0.999 * all["span_s"].get<double>());
    if (point["measured"].is_null()) continue;
    CHECK(point["threads"].get<int>() <= all["machine"]["cores"].get<int>());
    CHECK(point["measured"]["step_quartiles_s"][1].get<double>() > 0.0);
  }
}

}  // namespace

TEST_CASE("predict prints a table and a conclusion and writes its files") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"predict", shipped("simo_vu_quoc_beam"), "--set", "blade.bodies=2",
                                 "--threads", "4,1,4", "--formulation", "subsystem"},
                                folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part : {"T1 / Tinf", "a handover", "flow_graph", "auto", "predicted [us]",
                           "whatever the number of threads", "predict.html"}) {
    CAPTURE(part);
    CHECK(ended.out.find(part) != std::string::npos);
  }
  const fs::path results = folder.path() / "results" / "simo_vu_quoc_beam" / "predict";
  const json all = json::parse(file_text(results / "predict.json"));
  CHECK(all["kind"] == "predict");
  CHECK(all["model"]["formulation"] == "subsystem");
  CHECK(all["model"]["window_steps"] == 1);
  CHECK(all["runtime_costs"]["flow_graph_handover_s"].get<double>() > 0.0);
  CHECK(all["runtime_costs"]["flow_graph_counting_s"].get<double>() >= 0.0);
  CHECK(all["nodes"]["costs_s"].size() == all["model"]["run_nodes"].get<std::size_t>());
  CHECK(all["parallelism"].get<double>() >= 1.0);
  REQUIRE(all["points"].size() >= 5);  // serial, two executors or three on 1 and 4 threads
  CHECK(all["points"][0]["executor"] == "serial");
  CHECK_FALSE(all["points"][0]["measured"].is_null());
  check_points(all);
  const auto rows = lines_of(file_text(results / "predict.csv"));
  CHECK(rows.size() == all["points"].size() + 1);
  const std::string page = file_text(results / "predict.html");
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(page.find("T1 / max(T1/P, Tinf)") != std::string::npos);
}

TEST_CASE("predict takes auto in the window that it has in a run") {
  const WorkFolder folder;
  // Three blades of four bodies of four elements; as from a pipe, which can be read only once.
  const Ended ended = run_spoke({"predict", "/dev/stdin", "--threads", "1,2", "--out", "o"}, folder,
                                "", shipped("wu_haug_rotor"));
  CAPTURE(ended.err);
  CHECK(ended.status == 0);
  const json all = json::parse(file_text(folder.path() / "o" / "predict.json"));
  CHECK(all["model"]["window_steps"] == 1);
  const json& window = all["auto_window"];
  REQUIRE(window.is_object());
  const int steps = window["window_steps"].get<int>();
  CHECK(steps > 1);
  CHECK(window["nodes"]["costs_s"].size() == window["run_nodes"].get<std::size_t>());
  CHECK(ended.out.find("for windows of " + std::to_string(steps) + " steps") != std::string::npos);
  for (const json& point : all["points"]) {
    CAPTURE(point.dump());
    const bool may_have_window = point["executor"] == "auto" && point["threads"] == 2;
    // On a busy machine threads may cost more than they gain: auto then leaves its window.
    if (!may_have_window || point["clusters"] == 1) {
      CHECK(point["window_steps"] == 1);
      continue;
    }
    CHECK(point["window_steps"] == steps);
    // By T1 of the same graph: that of the other one was timed at other moments.
    CHECK(point["predicted_s"].get<double>() < window["work_s"].get<double>());
  }
}

TEST_CASE("predict of a window of steps") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"predict", shipped("wu_haug_rotor"), "--set", "blade.bodies=1",
                                 "--threads", "3", "--window", "4", "--out", "o"},
                                folder);
  CHECK(ended.status == 0);
  const json all = json::parse(file_text(folder.path() / "o" / "predict.json"));
  CHECK(all["model"]["window_steps"] == 4);
  CHECK(all["auto_window"].is_null());
  for (const json& point : all["points"]) CHECK(point["window_steps"] == 4);
  CHECK(all["nodes"]["runs_per_step"].get<double>() < 1.0);
  CHECK(all["parallelism"].get<double>() > 2.0);  // three blades that need not wait
  check_points(all);
}

TEST_CASE("predict refuses a bad command line in one line and writes nothing") {
  const WorkFolder folder;
  const auto refused = [&](std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"predict", shipped("simo_vu_quoc_beam")});
    check_refused(options, message, folder);
  };
  for (const std::string threads : {"0", "x", "1,,2", "1,", "", "5000"})
    refused({"--threads", threads}, "--threads: expected a number from 1 to 1024");
  refused({"--threads", "3x2"}, "--threads: executors with nested teams are not predicted");
  for (const std::string window : {"0", "-3", "x", "1001"})
    refused({"--window", window}, "--window: ");
  refused({"--formulation", "dense"}, "--formulation: ");
  refused({"--out", "/dev/null/x"}, "/dev/null/x: cannot be the folder of results");
  refused({"--set", "blade.bodies=-1"}, "blade.bodies");
}
