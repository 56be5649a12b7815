#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/contains.h"
#include "tests/program/cli/program.h"

namespace fs = std::filesystem;
using nlohmann::json;
using spoke::test::contains;

namespace {

json trace_in(const fs::path& folder) { return json::parse(file_text(folder / "trace.json")); }

/// The pictures in the page of a run.
json animation_in(const fs::path& folder) {
  const std::string page = file_text(folder / "report.html");
  const std::string mark = "id=\"run-data\">";
  const std::size_t begin = page.find(mark);
  REQUIRE(begin != std::string::npos);
  const std::size_t end = page.find("</script>", begin);
  return json::parse(page.substr(begin + mark.size(), end - begin - mark.size()))["animation"];
}

/// Returns the hash of the state in a folder's summary.json.
std::string hash_in(const fs::path& folder) {
  return json::parse(file_text(folder / "summary.json"))["state_hash"];
}

/// Returns what is printed of the steps themselves.
std::string before_more_threads(const std::string& out) {
  const std::size_t end = out.find("\nMore threads");
  REQUIRE(end != std::string::npos);
  return out.substr(0, end);
}

}  // namespace

TEST_CASE("trace writes its files and prints a summary") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--executor", "flow_graph", "--threads", "2",
                 "--from", "0.5", "--steps", "5", "--formulation", "subsystem"},
                folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  for (const char* part :
       {"5 steps from t = 0.505 s on", "flow_graph on 2 threads", "T1", "Tinf", "makespan",
        "speedup", "max(T1/2, Tinf)", "idle", "trace.json", "graph.dot"}) {
    CAPTURE(part);
    CHECK(contains(ended.out, part));
  }
  const fs::path results = folder.path() / "results" / "wu_haug_rotor" / "trace";
  const json trace = trace_in(results);
  REQUIRE(trace["spoke"]["steps"].size() == 5);
  CHECK(trace["spoke"]["steps"][0]["step"] == 101);
  CHECK(trace["spoke"]["settings"]["formulation"] == "subsystem");
  CHECK(trace["spoke"]["graph"]["name"].size() == 61);
  CHECK(file_text(results / "graph.dot").starts_with("digraph"));
}

TEST_CASE("trace says what more threads would gain") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"trace", shipped("wu_haug_rotor"), "--executor", "flow_graph",
                                 "--threads", "2", "--more-threads", "4,1,64,4", "--out", "o"},
                                folder);
  CHECK(ended.status == 0);
  for (const char* part : {"More threads, in runs of one pass: T1 = ", "list schedule", "auto"}) {
    CAPTURE(part);
    CHECK(contains(ended.out, part));
  }
  const json more = trace_in(folder.path() / "o")["spoke"]["more_threads"];
  const double bound = more["bound"];
  CHECK(more["passes_per_run"] == 1);
  CHECK(bound * more["span_s"].get<double>() == doctest::Approx(more["work_s"].get<double>()));
  const json& rows = more["predictions"];
  REQUIRE(rows.size() == 3);
  CHECK(rows[0]["threads"] == 1);
  CHECK(rows[0]["scheduled_s"].get<double>() == doctest::Approx(more["work_s"].get<double>()));
  CHECK(rows[0]["auto_clusters"] == 1);
  CHECK(rows[1]["threads"] == 4);
  for (const json& row : rows) {
    CHECK(row["scheduled_speedup"].get<double>() <= 1.000001 * bound);
    CHECK(row["auto_speedup"].get<double>() <= 1.000001 * bound);
  }
}

TEST_CASE("trace simulates more threads in the window that auto chooses") {
  const WorkFolder folder;
  const Ended automatic =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--threads", "2", "--out", "a"}, folder);
  CHECK(automatic.status == 0);
  const json more = trace_in(folder.path() / "a")["spoke"]["more_threads"];
  const int steps = more["window_steps"];
  CHECK(steps > 1);
  CHECK(more["passes_per_run"].get<int>() >= steps);
  CHECK(more["bound"].get<double>() > 2.0);  // three blades that need not wait
  CHECK(contains(automatic.out, "More threads, in windows of " + std::to_string(steps) + " steps"));
  CHECK(run_spoke(
            {"run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.1", "--trace", "r"},
            folder)
            .status == 0);
  CHECK(trace_in(folder.path() / "r")["spoke"]["more_threads"].is_null());
}

TEST_CASE("trace of a window of steps, and of what auto has not chosen yet") {
  const WorkFolder folder;
  const Ended window = run_spoke({"trace", shipped("wu_haug_rotor"), "--executor", "flow_graph",
                                  "--threads", "2", "--window", "4", "--out", "w"},
                                 folder);
  CHECK(window.status == 0);
  CHECK(contains(window.out, "windows of 4 steps"));
  CHECK(trace_in(folder.path() / "w")["spoke"]["settings"]["window_steps"] == 4);
  const Ended automatic =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--threads", "2", "--out", "a"}, folder);
  CHECK(automatic.status == 0);
  CHECK(contains(automatic.out, "auto has chosen nothing yet"));
  const json described = trace_in(folder.path() / "a")["spoke"];
  CHECK(described["settings"]["executor"] == "auto");
  CHECK(described["settings"]["threads"] == "1");
  REQUIRE(described["notes"].size() == 1);
  CHECK(contains(automatic.out, described["notes"][0].get<std::string>()));
  const Ended soon = run_spoke({"trace", shipped("wu_haug_rotor"), "--threads", "2", "--from",
                                "0.001", "--steps", "3", "--out", "s"},
                               folder);
  CHECK(contains(soon.out, "auto has chosen nothing yet"));
  const Ended alone =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--threads", "1", "--out", "one"}, folder);
  CHECK_FALSE(contains(before_more_threads(alone.out), "auto"));
  CHECK(trace_in(folder.path() / "one")["spoke"]["notes"].empty());
}

TEST_CASE("too few steps for a window are traced without, and what ran them is named") {
  const WorkFolder folder;
  const std::string remark =
      "20 steps are less than half a window of 100 steps, so they were traced without windows; "
      "spoke trace --steps 100 shows the windows";
  const Ended graph = run_spoke({"trace", shipped("wu_haug_rotor"), "--executor", "flow_graph",
                                 "--threads", "2", "--window", "100", "--out", "g"},
                                folder);
  CHECK(graph.status == 0);
  CHECK(contains(graph.out, "  flow_graph on 2 threads\n"));
  CHECK(contains(graph.out, remark));
  CHECK_FALSE(contains(before_more_threads(graph.out), "windows of 100"));
  const json described = trace_in(folder.path() / "g")["spoke"];
  CHECK(described["settings"]["description"] == "flow_graph on 2 threads");
  CHECK(described["settings"]["threads"] == "2");
  CHECK(described["settings"]["window_steps"] == 1);
  CHECK(described["notes"] == json::array({remark}));
  const Ended automatic = run_spoke(
      {"run", shipped("wu_haug_rotor"), "--threads", "2", "--window", "100", "--trace", "a"},
      folder);
  CHECK(automatic.status == 0);
  for (const std::string& part : {std::string("  serial on 1 thread\n"), remark,
                                  std::string("max(T1/1, Tinf)"), std::string("of 1 thread\n")}) {
    CAPTURE(part);
    CHECK(contains(automatic.out, part));
  }
  const json serial = trace_in(folder.path() / "a")["spoke"];
  CHECK(serial["settings"]["description"] == "serial on 1 thread");
  CHECK(serial["settings"]["threads"] == "1");
  CHECK(serial["threads"] == json::array({"main"}));
  const Ended one =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--executor", "serial", "--window", "9",
                 "--steps", "1", "--set", "integration.duration=0.02"},
                folder);
  CHECK(contains(
      one.out, "1 step is less than half a window of 9 steps, so it was traced without windows\n"));
}

TEST_CASE("a full buffer drops whole steps and says how many") {
  const WorkFolder folder;
  const Ended ended = run_spoke({"trace", shipped("wu_haug_rotor"), "--steps", "1000", "--executor",
                                 "serial", "--buffer", "1", "--out", "o"},
                                folder);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, " steps dropped, the buffer was full"));
  const json trace = trace_in(folder.path() / "o");
  const auto dropped = trace["spoke"]["dropped_steps"].get<std::size_t>();
  CHECK(dropped > 0);
  CHECK(trace["spoke"]["steps"].size() + dropped == 1000);
}

TEST_CASE("one dropped step is one step") {
  const WorkFolder folder;
  const auto trace = [&](std::size_t steps) {
    const Ended ended =
        run_spoke({"trace", shipped("wu_haug_rotor"), "--steps", std::to_string(steps),
                   "--executor", "serial", "--buffer", "1", "--out", "o"},
                  folder);
    CHECK(ended.status == 0);
    return ended.out;
  };
  trace(1000);
  std::size_t steps = trace_in(folder.path() / "o")["spoke"]["steps"].size();
  std::string out;
  while (!contains(out, " dropped")) out = trace(steps++);
  CHECK(contains(out, "; 1 step dropped, the buffer was full"));
}

TEST_CASE("steps of many iterations are not dropped while the buffer has room") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--executor", "serial", "--set",
                 "hub.drive.ramp=0.5", "--set", "integration.step=0.02", "--set",
                 "integration.duration=2", "--steps", "50", "--buffer", "16", "--out", "o"},
                folder);
  CHECK(ended.status == 0);
  const json trace = trace_in(folder.path() / "o")["spoke"];
  CHECK(trace["dropped_steps"] == 0);
  int most = 0;
  for (const json& step : trace["steps"]) most = std::max(most, step["passes"].get<int>());
  CHECK(most >= 6);
}

TEST_CASE("a buffer that no step fits into is refused, with one that would do") {
  const WorkFolder folder;
  const auto trace = [&](const std::string& buffer) {
    return run_spoke({"trace", shipped("large_rotor"), "--steps", "2", "--buffer", buffer,
                      "--executor", "flow_graph", "--threads", "64", "--out", "o"},
                     folder);
  };
  fs::create_directory(folder.path() / "o");
  folder.write("o/trace.json", "{}");  // of an earlier trace
  folder.write("o/trace.html", "<!doctype html>\n");
  folder.write("o/graph.dot", "digraph step {}\n");
  folder.write("o/graph.svg",
               "<?xml version=\"1.0\"?>\n<!-- Generated by graphviz version 7 -->\n");
  const Ended ended = trace("1");
  CHECK(ended.status == 2);
  CHECK(ended.out.empty());
  REQUIRE(lines_of(ended.err).size() == 1);
  const std::string expected = "spoke trace: --buffer 1: no step fits, expected at least ";
  REQUIRE(ended.err.starts_with(expected));
  CHECK(contains(ended.err, ", for all 2 steps "));
  CHECK(fs::is_empty(folder.path() / "o"));
  const int needed = std::stoi(ended.err.substr(expected.size()));
  CHECK(needed > 1);
  CHECK(trace(std::to_string(needed)).status == 0);
  CHECK(trace_in(folder.path() / "o")["spoke"]["steps"].size() >= 1);
}

TEST_CASE("run --trace writes the trace, too, and the same results") {
  const WorkFolder folder;
  const std::vector<std::string> plain{"run",       shipped("wu_haug_rotor"),
                                       "--set",     "integration.duration=0.5",
                                       "--out",     "plain",
                                       "--threads", "2"};
  CHECK(run_spoke(plain, folder).status == 0);
  std::vector<std::string> traced = plain;
  traced[5] = "traced";
  traced.insert(traced.end(), {"--trace", "t"});
  const Ended ended = run_spoke(traced, folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(contains(ended.out, "20 steps from t = 0.005 s on"));
  CHECK(trace_in(folder.path() / "t")["spoke"]["steps"].size() == 20);
  CHECK(hash_in(folder.path() / "plain") == hash_in(folder.path() / "traced"));
  CHECK(file_text(folder.path() / "plain" / "sensors.csv") ==
        file_text(folder.path() / "traced" / "sensors.csv"));
  traced.insert(traced.end(), {"--quiet"});
  CHECK(run_spoke(traced, folder).out.empty());
}

TEST_CASE("run --trace leaves pictures, files for ParaView and checkpoints, and traces 20 steps") {
  using Words = std::vector<std::string>;
  const WorkFolder folder;
  const auto run = [&](Words words, const std::string& out) {
    words.insert(words.begin(),
                 {"run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.15", "--set",
                  "output.interval=0.005", "--threads", "2", "--out", out});
    const Ended ended = run_spoke(words, folder);
    CHECK(ended.status == 0);
    return ended.out;
  };
  for (const Words& words :
       {Words{}, Words{"--vtk"}, Words{"--executor", "flow_graph", "--window", "8"},
        Words{"--vtk", "--executor", "flow_graph", "--window", "8", "--set",
              "output.interval=0.035"},
        Words{"--checkpoint-every", "1e-9"}}) {
    CAPTURE(words.size());
    const fs::path plain = folder.path() / "plain", traced = folder.path() / "traced";
    run(words, "plain");
    Words more = words;
    more.insert(more.end(), {"--trace", "t"});
    CHECK(contains(run(more, "traced"), "20 steps from t = 0.005 s on"));
    const json steps = trace_in(folder.path() / "t")["spoke"]["steps"];
    REQUIRE(steps.size() == 20);
    for (std::size_t k = 0; k < steps.size(); ++k) CHECK(steps[k]["step"] == k + 1);
    CHECK(animation_in(plain)["times"] != "");
    CHECK(animation_in(plain) == animation_in(traced));
    for (const char* file : {"sensors.csv", "vtk/blades.pvd", "vtk/blades_000003.vtp"})
      CHECK(file_text(plain / file) == file_text(traced / file));
    CHECK(fs::exists(plain / "checkpoint.spoke") == fs::exists(traced / "checkpoint.spoke"));
    CHECK(hash_in(plain) == hash_in(traced));
  }
}

TEST_CASE("a run shorter than the trace is traced as a whole") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"run", shipped("wu_haug_rotor"), "--set", "integration.duration=0.015", "--trace", "t"},
      folder);
  CHECK(ended.status == 0);
  CHECK(trace_in(folder.path() / "t")["spoke"]["steps"].size() == 3);
}

TEST_CASE("a trace that diverges ends with status 3 and writes nothing") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"trace", shipped("wu_haug_rotor"), "--set", "blade.bodies=1", "--set",
                 "blade.geometric_stiffening=false", "--from", "15", "--executor", "serial"},
                folder);
  CHECK(ended.status == 3);
  CHECK(ended.out.empty());
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(contains(ended.err, "diverged at t = "));
  CHECK(folder.entries() == 0);
}

TEST_CASE("a trace of steps that diverge holds those before, and replaces an earlier one") {
  const WorkFolder folder;
  fs::create_directory(folder.path() / "t");
  folder.write("t/trace.json", "{}");  // of an earlier trace
  for (const std::string command : {"run", "trace"}) {
    CAPTURE(command);
    const Ended ended =
        run_spoke({command, shipped("wu_haug_rotor"), "--integrator", "rk4", "--executor", "serial",
                   command == "run" ? "--trace" : "--out", "t"},
                  folder);
    CHECK(ended.status == 3);
    CHECK(contains(ended.out, " steps from t = 0.005 s on"));
    CHECK(contains(lines_of(ended.err).back(), "diverged at t = "));
    const json trace = trace_in(folder.path() / "t")["spoke"];
    CHECK(trace["steps"].size() >= 1);
    CHECK(trace["steps"].size() < 20);
    CHECK(trace["dropped_steps"] == 0);
    REQUIRE(trace["notes"].size() == 1);
    CHECK(trace["notes"][0] == "the recording ends after " + std::to_string(trace["steps"].size()) +
                                   " of 20 steps: the simulation ended or was interrupted");
    CHECK(contains(ended.out, trace["notes"][0].get<std::string>()));
  }
}

TEST_CASE("a run whose trace has no step says so, and leaves no earlier trace") {
  const WorkFolder folder;
  const auto warned = [&](std::vector<std::string> options, int status, const std::string& why) {
    fs::create_directory(folder.path() / "t");
    folder.write("t/trace.json", "{}");  // of an earlier trace
    options.insert(options.begin(), {"run", shipped("wu_haug_rotor"), "--quiet", "--trace", "t"});
    const Ended ended = run_spoke(options, folder);
    CAPTURE(ended.err);
    CHECK(ended.status == status);
    CHECK(ended.out.empty());
    CHECK(ended.err.starts_with("warning: no trace written to t: " + why));
    CHECK(fs::is_empty(folder.path() / "t"));
    return ended;
  };
  warned({"--integrator", "rk4", "--set", "integration.step=10"}, 3,
         "the run ended before a step was complete");
  const Ended wide = warned({"--set", "blade.count=1000", "--set", "blade.bodies=3", "--set",
                             "blade.elements=1", "--set", "integration.duration=0.005",
                             "--executor", "flow_graph", "--threads", "1024", "--no-report"},
                            0, "no step fitted into its buffer; spoke trace --buffer ");
  CHECK(contains(wide.err, " would do"));
  const std::vector<std::string> second{"--set", "integration.duration=1"};
  std::vector<std::string> run = second;
  run.insert(run.begin(), {"run", shipped("wu_haug_rotor"), "--quiet", "--checkpoint-every", "9"});
  REQUIRE(run_spoke(run, folder).status == 0);
  std::vector<std::string> resumed = second;
  resumed.insert(resumed.end(), {"--resume", "results/wu_haug_rotor/checkpoint.spoke"});
  CHECK(lines_of(warned(resumed, 0, "the run had come to its end before").err).size() == 1);
}

TEST_CASE("a scenario of few steps is traced as a whole unless a number is asked for") {
  const WorkFolder folder;
  const Ended ended = run_spoke(
      {"trace", shipped("wu_haug_rotor"), "--set", "integration.duration=0.02", "--out", "t"},
      folder);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(contains(ended.out, "4 steps from t = 0.005 s on"));
}

TEST_CASE("trace refuses a bad command line in one line and writes nothing") {
  const WorkFolder folder;
  const auto refused = [&](std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"trace", shipped("wu_haug_rotor")});
    const Ended ended = run_spoke(options, folder);
    CAPTURE(message);
    CAPTURE(ended.err);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(lines_of(ended.err).size() == 1);
    CHECK(contains(ended.err, message));
    CHECK(folder.entries() == 0);
  };
  for (const std::string steps : {"0", "-3", "x", "1.5", "100001"})
    refused({"--steps", steps}, "--steps: ");
  refused({"--steps", "4001"}, "--steps 4001: the scenario has 4000 steps, expected at most 4000");
  for (const std::string from : {"-1", "x", "nan", "inf", "", "1s"})
    refused({"--from", from}, "--from: expected a time in s, 0 or more, got " + from);
  refused({"--from", "30"},
          "--from 30: 4000 steps of 0.005 s end at 20 s, expected at most 19.9 s");
  refused({"--from", "19.95"}, "expected at most 19.9 s");
  for (const std::string buffer : {"0", "x", "-1", "1e9"})
    refused({"--buffer", buffer}, "--buffer: expected 1 to 65536 megabytes, got " + buffer);
  for (const std::string window : {"0", "x", "1001"}) refused({"--window", window}, "--window: ");
  refused({"--executor", "none"}, "--executor: ");
  refused({"--executor", "flow_graph", "--threads", "2x2"}, "--threads: ");
  refused({"--out", "/dev/null/x"}, "/dev/null/x: cannot be the folder of results");
  refused({"--set", "blade.bodies=-1"}, "blade.bodies");
}

TEST_CASE("run refuses a folder of traces that cannot be made, before it runs") {
  const WorkFolder folder;
  const Ended ended =
      run_spoke({"run", shipped("wu_haug_rotor"), "--trace", "/dev/null/x"}, folder);
  CHECK(ended.status == 2);
  CHECK(lines_of(ended.err).size() == 1);
  CHECK(contains(ended.err, "/dev/null/x: cannot be the folder of results"));
  CHECK(folder.entries() == 0);
}
